/// The project file: one SQLite database (WAL) that survives `kill -9`. No SQL anywhere else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::store {

/// Raised when the meaning of a table changes. A file with a higher number is refused and left alone.
constexpr int kSchemaVersion = 1;

/// True if `path` is the project's file or one that SQLite keeps beside it, by any name or link. Writing anything else
/// there would destroy the project, so that outputs are checked with it first.
bool is_part_of_project(const std::filesystem::path& path, const std::filesystem::path& project);

/// One committed edit: a node of the history tree.
struct JournalRow {
  std::int64_t id = 0;      ///< 1, 2, … in the order of committing.
  std::int64_t parent = 0;  ///< 0: the empty project.
  std::string time;         ///< ISO 8601, UTC.
  std::string name;
  std::string parameters;   ///< A JSON object.
  std::string description;  ///< For people.
};

/// Where redo goes from `parent`.
struct RedoRow {
  std::int64_t parent = 0;
  std::int64_t child = 0;
};

/// A piece of a recording: whole samples, in order.
struct Chunk {
  std::int64_t sequence = 0;
  std::string bytes;
};

struct RecordingRow {
  std::int64_t id = 0;
  bool finished = false;
  std::string header;  ///< JSON, written when the recording begins.
  std::string footer;  ///< JSON, written when it is finished.
  /// The program that began it still has the project open; if not, what is unfinished was cut off.
  bool writer_lives = false;
};

/// A named blob that is written once: models, rollout sets.
struct ObjectRow {
  std::int64_t id = 0;
  std::string kind;
  std::string meta;             ///< JSON.
  std::int64_t size_bytes = 0;  ///< Of its bytes, which are not read for this.
};

/// Every write is its own transaction unless inside `transaction`, and survives `kill -9` once it has returned. Several
/// programs may have a project open; their writes take turns. Closing leaves the one file.
/// Errors of every function: kIo (locked, full disk, read-only), kCorrupt (damaged). Threads: one at a time.
class ProjectStore {
 public:
  /// Errors: kIo (exists already, folder missing, not writable).
  static Result<ProjectStore> create(const std::filesystem::path& path);
  /// `kRead` changes nothing and needs no right to write, neither to the file nor to its folder; where there is that
  /// right, the file's log is still tidied up.
  enum class Access { kRead, kWrite };
  /// Errors: kCorrupt (not a project, truncated); kUnsupported (newer schema); kIo (missing, locked, unreadable, or a
  /// log that cannot be read without the right to write).
  static Result<ProjectStore> open(const std::filesystem::path& path, Access access = Access::kWrite);
  ~ProjectStore();
  ProjectStore(ProjectStore&&) noexcept;
  ProjectStore& operator=(ProjectStore&&) noexcept;

  Result<std::vector<JournalRow>> journal() const;
  /// The rows after `id`.
  Result<std::vector<JournalRow>> journal_after(std::int64_t id) const;
  /// Appends with the row's id, or with the next one where that is 0, moves HEAD to it and lets redo lead to it, in one
  /// transaction; returns the id.
  Result<std::int64_t> append(const JournalRow& row);
  Result<std::int64_t> head() const;
  Status set_head(std::int64_t id);
  /// Moves HEAD and notes where redo goes, in one transaction.
  Status set_head(std::int64_t id, const std::vector<RedoRow>& redo);
  Result<std::vector<RedoRow>> redo() const;

  Result<std::int64_t> begin_recording(const std::string& header);
  /// Durable when it returns.
  Status append_chunk(std::int64_t recording, const Chunk& chunk);
  /// Errors: kNotFound if there is no such unfinished recording.
  Status finish_recording(std::int64_t recording, const std::string& footer);
  Result<std::vector<RecordingRow>> recordings() const;
  Result<std::vector<Chunk>> chunks(std::int64_t recording) const;
  /// Visits the chunks in order without copying them; stops at the first error that `visit` returns.
  Status visit_chunks(std::int64_t recording,
                      const std::function<Status(std::int64_t sequence, std::string_view bytes)>& visit) const;
  /// Takes a recording out for good, with all its chunks.
  Status discard_recording(std::int64_t recording);
  /// Nobody writes the recording any more: it counts as cut off, also while this program lives.
  Status abandon_recording(std::int64_t recording);

  Result<std::int64_t> put_object(const std::string& kind, const std::string& meta, const std::string& bytes);
  Result<std::vector<ObjectRow>> objects(const std::string& kind) const;
  Result<std::string> object_bytes(std::int64_t id) const;

  Status set_setting(const std::string& key, const std::string& value);
  Result<std::optional<std::string>> setting(const std::string& key) const;
  /// All whose keys begin with `prefix`, by what follows it.
  Result<std::map<std::string, std::string>> settings_under(const std::string& prefix) const;

  /// Runs `work` as one transaction; if it returns an error, nothing of it stays.
  Status transaction(const std::function<Status()>& work);
  /// Runs `work`, which only reads, so that all it reads is of one moment.
  Status snapshot(const std::function<Status()>& work);
  /// True if another program has changed the project since this was last asked.
  Result<bool> changed_elsewhere();

  /// How long a write waits for those of other programs; 500 ms to begin with. 0: it is an error at once.
  void set_patience_ms(int patience_ms);
  /// The last error was that another program is writing: nothing has changed, and it can be tried again.
  bool held_elsewhere() const;

  /// Of the file and its log.
  std::int64_t size_bytes() const;
  const std::filesystem::path& path() const;

 private:
  struct Impl;
  explicit ProjectStore(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::store
