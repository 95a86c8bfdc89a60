#include "engine/store/project_store.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "engine/core/file.h"
#include "engine/store/database.h"
#include "engine/store/schema.h"
#include "engine/store/writer_mark.h"

namespace trocar::store {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> refuse(ErrorCode code, std::string message, const fs::path& path) {
  return tl::unexpected(Error(code, std::move(message)).at(path.string()));
}

/// Makes the whole file under another name, so that nobody ever meets half a project.
Status write_empty(const fs::path& path) {
  TROCAR_ASSIGN_OR_RETURN(Database database, Database::open(path, Database::Access::kCreate));
  return database.execute(kSchemaSql);
}

/// The project and what SQLite may keep beside it.
constexpr std::array kSuffixes = {"", "-wal", "-shm", "-journal"};

void remove_with_log(const fs::path& path) {
  std::error_code ignored;
  for (const char* suffix : kSuffixes) fs::remove(fs::path(path) += suffix, ignored);
}

/// The error's sentence without the name of a file that the user has never heard of.
std::string reason_of(const Status& failed, const fs::path& temporary) {
  std::string text = failed.error().text();
  const std::string ending = ": " + temporary.string();
  if (text.ends_with(ending)) text.resize(text.size() - ending.size());
  return text;
}

bool may_write(const fs::path& path) {
  return ::access(path.c_str(), W_OK) == 0;
}

/// SQLite reads a log through a file that it makes beside it. Where it may not, a project without a log is read as one
/// that nobody changes.
Result<Database> open_to_read(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (may_write(path) && may_write(folder)) {
    TROCAR_ASSIGN_OR_RETURN(Database database, Database::open(path, Database::Access::kWrite));
    TROCAR_RETURN_IF_ERROR(database.execute("PRAGMA query_only = 1"));
    return database;
  }
  std::error_code error;
  const std::uintmax_t log_size = fs::file_size(log_of(path), error);
  if (error || log_size == 0) return Database::open(path, Database::Access::kImmutable);
  TROCAR_ASSIGN_OR_RETURN(Database database, Database::open(path, Database::Access::kReadOnly));
  if (database.integer("SELECT node FROM head", {}, 0)) return database;
  return refuse(ErrorCode::kIo,
                "the project has changes in a log that cannot be read without the right to write beside it; copy both "
                "to another folder",
                log_of(path));
}

/// A name for comparisons, also of what does not exist.
fs::path full_name(const fs::path& path) {
  std::error_code error;
  const fs::path target = replaceable_file(path).value_or(path);
  const fs::path full = fs::weakly_canonical(fs::absolute(target, error), error);
  return error ? target : full;
}

}  // namespace

bool is_part_of_project(const fs::path& path, const fs::path& project) {
  const fs::path whole = full_name(project);
  const fs::path asked = full_name(path);
  for (const char* suffix : kSuffixes) {
    const fs::path part = fs::path(whole) += suffix;
    std::error_code error;
    if (asked == part || fs::equivalent(path, part, error)) return true;
  }
  return false;
}

struct ProjectStore::Impl {
  explicit Impl(Database opened) : database(std::move(opened)) {}
  ~Impl() {
    // A failure only delays the recovery until this program ends.
    for (const std::int64_t id : writing) (void)abandon(id);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Status abandon(std::int64_t id) { return database.run("UPDATE recordings SET writer = '' WHERE id = ?", {id}); }

  Database database;
  std::set<std::int64_t> writing;  ///< Recordings that this store began.
  std::int64_t seen_version = 0;
};

ProjectStore::ProjectStore(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProjectStore::~ProjectStore() = default;
ProjectStore::ProjectStore(ProjectStore&&) noexcept = default;
ProjectStore& ProjectStore::operator=(ProjectStore&&) noexcept = default;

Result<ProjectStore> ProjectStore::create(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) return refuse(ErrorCode::kIo, "the file exists already", path);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) return refuse(ErrorCode::kIo, "the folder does not exist", path);
  // SQLite would mix a log that is left of another project into the new one.
  if (fs::exists(log_of(path), error)) {
    return refuse(ErrorCode::kIo, "the log of another project is in the way", log_of(path));
  }
  const fs::path temporary = temporary_beside(path);
  Status made = write_empty(temporary);
  if (made) {
    fs::rename(temporary, path, error);
    if (error) made = fail(ErrorCode::kIo, error.message());
  }
  if (!made) {
    remove_with_log(temporary);
    return refuse(made.error().code(), fmt::format("the project cannot be created ({})", reason_of(made, temporary)),
                  path);
  }
  return open(path);
}

Result<ProjectStore> ProjectStore::open(const fs::path& path, Access access) {
  TROCAR_RETURN_IF_ERROR(check_header(path));
  TROCAR_ASSIGN_OR_RETURN(
      Database database, access == Access::kRead ? open_to_read(path) : Database::open(path, Database::Access::kWrite));
  TROCAR_RETURN_IF_ERROR(database.execute("PRAGMA synchronous = NORMAL; PRAGMA cache_size = -8192;"));
  ProjectStore store(std::make_unique<Impl>(std::move(database)));
  TROCAR_RETURN_IF_ERROR(store.changed_elsewhere());
  TROCAR_RETURN_IF_ERROR(store.head());
  return store;
}

Result<bool> ProjectStore::changed_elsewhere() {
  TROCAR_ASSIGN_OR_RETURN(const std::int64_t version, impl_->database.integer("PRAGMA data_version", {}, 0));
  return std::exchange(impl_->seen_version, version) != version;
}

Status ProjectStore::transaction(const std::function<Status()>& work) {
  if (impl_->database.in_transaction()) return work();
  TROCAR_RETURN_IF_ERROR(impl_->database.run("BEGIN IMMEDIATE"));
  Status done = work();
  if (done) done = impl_->database.run("COMMIT");
  // A full disk may have rolled the transaction back already.
  if (!done && impl_->database.in_transaction()) (void)impl_->database.run("ROLLBACK");
  return done;
}

Status ProjectStore::snapshot(const std::function<Status()>& work) {
  if (impl_->database.in_transaction()) return work();
  TROCAR_RETURN_IF_ERROR(impl_->database.run("BEGIN"));
  Status done = work();
  if (impl_->database.in_transaction()) (void)impl_->database.run("ROLLBACK");
  return done;
}

void ProjectStore::set_patience_ms(int patience_ms) {
  impl_->database.set_patience_ms(patience_ms);
}

bool ProjectStore::held_elsewhere() const {
  return impl_->database.held_elsewhere();
}

Result<std::vector<JournalRow>> ProjectStore::journal() const {
  return journal_after(0);
}

Result<std::vector<JournalRow>> ProjectStore::journal_after(std::int64_t id) const {
  std::vector<JournalRow> rows;
  TROCAR_RETURN_IF_ERROR(impl_->database.query(
      "SELECT id, parent, time, name, parameters, description FROM journal WHERE id > ? ORDER BY id", {id},
      [&](const Row& row) {
        rows.push_back({row.integer(0), row.integer(1), row.text(2), row.text(3), row.text(4), row.text(5)});
        return Status();
      }));
  return rows;
}

Result<std::int64_t> ProjectStore::append(const JournalRow& row) {
  std::int64_t id = 0;
  Database& database = impl_->database;
  const auto work = [&]() -> Status {
    TROCAR_RETURN_IF_ERROR(
        database.run("INSERT INTO journal(id, parent, time, name, parameters, description) "
                     "VALUES (NULLIF(?, 0), ?, ?, ?, ?, ?)",
                     {row.id, row.parent, std::string_view(row.time), std::string_view(row.name),
                      std::string_view(row.parameters), std::string_view(row.description)}));
    id = database.last_id();
    return set_head(id, {{row.parent, id}});
  };
  TROCAR_RETURN_IF_ERROR(transaction(work));
  return id;
}

Result<std::int64_t> ProjectStore::head() const {
  return impl_->database.integer("SELECT node FROM head", {}, 0);
}

Status ProjectStore::set_head(std::int64_t id) {
  return impl_->database.run("UPDATE head SET node = ?", {id});
}

Status ProjectStore::set_head(std::int64_t id, const std::vector<RedoRow>& redo) {
  return transaction([&]() -> Status {
    for (const RedoRow& row : redo) {
      TROCAR_RETURN_IF_ERROR(
          impl_->database.run("INSERT OR REPLACE INTO redo(parent, child) VALUES (?, ?)", {row.parent, row.child}));
    }
    return set_head(id);
  });
}

Result<std::vector<RedoRow>> ProjectStore::redo() const {
  std::vector<RedoRow> rows;
  TROCAR_RETURN_IF_ERROR(impl_->database.query("SELECT parent, child FROM redo", {}, [&](const Row& row) {
    rows.push_back({row.integer(0), row.integer(1)});
    return Status();
  }));
  return rows;
}

Result<std::int64_t> ProjectStore::begin_recording(const std::string& header) {
  const std::string mark = writer_mark();
  TROCAR_RETURN_IF_ERROR(
      impl_->database.run("INSERT INTO recordings(finished, writer, header, footer) VALUES (0, ?, ?, '')",
                          {std::string_view(mark), std::string_view(header)}));
  impl_->writing.insert(impl_->database.last_id());
  return impl_->database.last_id();
}

Status ProjectStore::append_chunk(std::int64_t recording, const Chunk& chunk) {
  return impl_->database.run("INSERT INTO chunks(recording, sequence, bytes) VALUES (?, ?, ?)",
                             {recording, chunk.sequence, Blob{chunk.bytes}});
}

Status ProjectStore::finish_recording(std::int64_t recording, const std::string& footer) {
  TROCAR_RETURN_IF_ERROR(
      impl_->database.run("UPDATE recordings SET finished = 1, footer = ? WHERE id = ? AND finished = 0",
                          {std::string_view(footer), recording}));
  if (impl_->database.changes() != 1) {
    return refuse(ErrorCode::kNotFound, fmt::format("there is no unfinished recording {}", recording), path());
  }
  return {};
}

Status ProjectStore::discard_recording(std::int64_t recording) {
  return transaction([&]() -> Status {
    TROCAR_RETURN_IF_ERROR(impl_->database.run("DELETE FROM chunks WHERE recording = ?", {recording}));
    return impl_->database.run("DELETE FROM recordings WHERE id = ?", {recording});
  });
}

Status ProjectStore::abandon_recording(std::int64_t recording) {
  return impl_->abandon(recording);
}

Result<std::vector<RecordingRow>> ProjectStore::recordings() const {
  std::vector<RecordingRow> rows;
  TROCAR_RETURN_IF_ERROR(impl_->database.query(
      "SELECT id, finished, header, footer, writer FROM recordings ORDER BY id", {}, [&](const Row& row) {
        rows.push_back({row.integer(0), row.integer(1) != 0, row.text(2), row.text(3), writer_lives(row.bytes(4))});
        return Status();
      }));
  return rows;
}

Result<std::vector<Chunk>> ProjectStore::chunks(std::int64_t recording) const {
  std::vector<Chunk> found;
  TROCAR_RETURN_IF_ERROR(visit_chunks(recording, [&](std::int64_t sequence, std::string_view bytes) {
    found.push_back({sequence, std::string(bytes)});
    return Status();
  }));
  return found;
}

Status ProjectStore::visit_chunks(std::int64_t recording,
                                  const std::function<Status(std::int64_t, std::string_view)>& visit) const {
  return impl_->database.query("SELECT sequence, bytes FROM chunks WHERE recording = ? ORDER BY sequence", {recording},
                               [&](const Row& row) { return visit(row.integer(0), row.bytes(1)); });
}

Result<std::int64_t> ProjectStore::put_object(const std::string& kind, const std::string& meta,
                                              const std::string& bytes) {
  TROCAR_RETURN_IF_ERROR(impl_->database.run("INSERT INTO objects(kind, meta, bytes) VALUES (?, ?, ?)",
                                             {std::string_view(kind), std::string_view(meta), Blob{bytes}}));
  return impl_->database.last_id();
}

Result<std::vector<ObjectRow>> ProjectStore::objects(const std::string& kind) const {
  std::vector<ObjectRow> rows;
  TROCAR_RETURN_IF_ERROR(
      impl_->database.query("SELECT id, kind, meta, length(bytes) FROM objects WHERE kind = ? ORDER BY id",
                            {std::string_view(kind)}, [&](const Row& row) {
                              rows.push_back({row.integer(0), row.text(1), row.text(2), row.integer(3)});
                              return Status();
                            }));
  return rows;
}

Result<std::string> ProjectStore::object_bytes(std::int64_t id) const {
  std::optional<std::string> bytes;
  TROCAR_RETURN_IF_ERROR(impl_->database.query("SELECT bytes FROM objects WHERE id = ?", {id}, [&](const Row& row) {
    bytes = row.text(0);
    return Status();
  }));
  if (!bytes) return refuse(ErrorCode::kNotFound, fmt::format("the project has no object {}", id), path());
  return std::move(*bytes);
}

Status ProjectStore::set_setting(const std::string& key, const std::string& value) {
  return impl_->database.run("INSERT OR REPLACE INTO settings(key, value) VALUES (?, ?)",
                             {std::string_view(key), std::string_view(value)});
}

Result<std::optional<std::string>> ProjectStore::setting(const std::string& key) const {
  std::optional<std::string> value;
  TROCAR_RETURN_IF_ERROR(
      impl_->database.query("SELECT value FROM settings WHERE key = ?", {std::string_view(key)}, [&](const Row& row) {
        value = row.text(0);
        return Status();
      }));
  return value;
}

Result<std::map<std::string, std::string>> ProjectStore::settings_under(const std::string& prefix) const {
  std::map<std::string, std::string> found;
  TROCAR_RETURN_IF_ERROR(impl_->database.query("SELECT key, value FROM settings WHERE substr(key, 1, length(?1)) = ?1",
                                               {std::string_view(prefix)}, [&](const Row& row) {
                                                 found[std::string(row.text(0)).substr(prefix.size())] = row.text(1);
                                                 return Status();
                                               }));
  return found;
}

std::int64_t ProjectStore::size_bytes() const {
  std::uintmax_t total = 0;
  for (const fs::path& part : {path(), log_of(path())}) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(part, error);
    if (!error) total += size;
  }
  return static_cast<std::int64_t>(total);
}

const fs::path& ProjectStore::path() const {
  return impl_->database.path();
}

}  // namespace trocar::store
