/// The project file: one SQLite database (WAL) that survives `kill -9`. No SQL anywhere else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace trocar::store {

/// Raised when the meaning of a table changes. A file with a higher number is refused and left alone.
constexpr int kSchemaVersion = 1;

/// One committed edit: a node of the history tree.
struct JournalRow {
  std::int64_t id = 0;      ///< 1, 2, … in the order of committing.
  std::int64_t parent = 0;  ///< 0: the empty project.
  std::string time;         ///< ISO 8601, UTC.
  std::string name;
  std::string parameters;  ///< A JSON object.
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
};

/// A named blob that is written once: models, rollout sets.
struct ObjectRow {
  std::int64_t id = 0;
  std::string kind;
  std::string meta;  ///< JSON.
};

/// Every write is its own transaction unless inside `transaction`. Threads: one at a time.
class ProjectStore {
 public:
  /// Errors: kIo (exists already, folder missing, not writable).
  static Result<ProjectStore> create(const std::filesystem::path& path);
  /// Errors: kNotFound; kCorrupt (not a project, truncated); kUnsupported (newer schema); kIo (locked, unreadable).
  static Result<ProjectStore> open(const std::filesystem::path& path);
  ~ProjectStore();
  ProjectStore(ProjectStore&&) noexcept;
  ProjectStore& operator=(ProjectStore&&) noexcept;

  Result<std::vector<JournalRow>> journal() const;
  /// Appends with the next id and moves HEAD to it, in one transaction; returns the id.
  Result<std::int64_t> append(const JournalRow& row);
  Result<std::int64_t> head() const;
  Status set_head(std::int64_t id);

  Result<std::int64_t> begin_recording(const std::string& header);
  /// Durable when it returns.
  Status append_chunk(std::int64_t recording, const Chunk& chunk);
  Status finish_recording(std::int64_t recording, const std::string& footer);
  Result<std::vector<RecordingRow>> recordings() const;
  Result<std::vector<Chunk>> chunks(std::int64_t recording) const;

  Result<std::int64_t> put_object(const std::string& kind, const std::string& meta, const std::string& bytes);
  Result<std::vector<ObjectRow>> objects(const std::string& kind) const;
  Result<std::string> object_bytes(std::int64_t id) const;

  Status set_setting(const std::string& key, const std::string& value);
  Result<std::optional<std::string>> setting(const std::string& key) const;

  std::int64_t size_bytes() const;
  const std::filesystem::path& path() const;

 private:
  struct Impl;
  explicit ProjectStore(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::store
