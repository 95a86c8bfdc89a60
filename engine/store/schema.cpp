#include "engine/store/schema.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "engine/store/project_store.h"

namespace trocar::store {
namespace {

constexpr std::uint32_t kApplicationId = 0x54524F43;  // "TROC"
constexpr std::size_t kHeaderSize = 100;              // Of the SQLite file format, section 1.3.
constexpr std::string_view kMagic("SQLite format 3\0", 16);

using Header = std::array<unsigned char, kHeaderSize>;

std::uint32_t big_endian(const Header& header, std::size_t offset) {
  return std::uint32_t{header[offset]} << 24 | std::uint32_t{header[offset + 1]} << 16 |
         std::uint32_t{header[offset + 2]} << 8 | std::uint32_t{header[offset + 3]};
}

std::uintmax_t size_or_zero(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

Status check_bytes(const Header& header, std::uintmax_t file_size, bool log_pending) {
  if (std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0) {
    return fail(ErrorCode::kCorrupt, "the file is not a Trocar project");
  }
  if (big_endian(header, 68) != kApplicationId) {
    return fail(ErrorCode::kCorrupt, "the file is a database of another program, not a Trocar project");
  }
  const std::uint32_t schema = big_endian(header, 60);
  if (schema > static_cast<std::uint32_t>(kSchemaVersion)) {
    return fail(ErrorCode::kUnsupported, fmt::format("the project was written by a newer Trocar (schema {}, this one "
                                                     "reads up to {})",
                                                     schema, kSchemaVersion));
  }
  if (schema == 0) return fail(ErrorCode::kCorrupt, "the project has no schema number");
  const std::uint32_t stored = std::uint32_t{header[16]} << 8 | std::uint32_t{header[17]};
  const std::uintmax_t page_size = stored == 1 ? 65536 : stored;
  const std::uintmax_t expected = page_size * big_endian(header, 28);
  // With a log the last pages may be in the log only, and SQLite itself puts them together.
  if (!log_pending && file_size < expected) {
    return fail(ErrorCode::kCorrupt,
                fmt::format("the project is truncated, {} of {} bytes are there", file_size, expected));
  }
  return {};
}

}  // namespace

const char* const kSchemaSql = R"sql(
PRAGMA page_size = 8192;
PRAGMA application_id = 1414680387;
PRAGMA user_version = 1;
BEGIN;
-- Every committed edit: a node of the history tree. parent 0 is the empty project.
CREATE TABLE journal(
  id INTEGER PRIMARY KEY,
  parent INTEGER NOT NULL,
  time TEXT NOT NULL,         -- ISO 8601, UTC
  name TEXT NOT NULL,         -- the kind of edit: 'edit demonstration'
  parameters TEXT NOT NULL,   -- a JSON object
  description TEXT NOT NULL   -- for people: 'Trim Expert 1 to 0.40-12.30 s'
);
CREATE INDEX journal_parent ON journal(parent);
-- One row: the node that the project stands at.
CREATE TABLE head(only INTEGER PRIMARY KEY CHECK (only = 1), node INTEGER NOT NULL);
INSERT INTO head VALUES (1, 0);
-- Where redo goes from a node: the child last committed, or last left by an undo.
CREATE TABLE redo(parent INTEGER PRIMARY KEY, child INTEGER NOT NULL);
CREATE TABLE recordings(
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  finished INTEGER NOT NULL,  -- 0 while it is written, and after a crash
  writer TEXT NOT NULL,       -- the process that began it and lives: 'pid start boot', or ''
  header TEXT NOT NULL,       -- a JSON object: format, provenance
  footer TEXT NOT NULL        -- a JSON object: outcome, samples, content hash
);
-- Whole samples in order; sequence 0 is the simulated world before the first one.
CREATE TABLE chunks(
  recording INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  bytes BLOB NOT NULL,
  UNIQUE(recording, sequence)
);
-- Blobs that are written once: models.
CREATE TABLE objects(
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  kind TEXT NOT NULL,
  meta TEXT NOT NULL,         -- a JSON object
  bytes BLOB NOT NULL
);
CREATE INDEX objects_kind ON objects(kind);
CREATE TABLE settings(key TEXT PRIMARY KEY, value TEXT NOT NULL);
COMMIT;
PRAGMA journal_mode = WAL;
)sql";

std::filesystem::path log_of(const std::filesystem::path& path) {
  std::filesystem::path log = path;
  log += "-wal";
  return log;
}

Status check_header(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    return tl::unexpected(Error(ErrorCode::kIo, "there is no such project").at(path.string()));
  }
  if (!std::filesystem::is_regular_file(status)) {
    return tl::unexpected(Error(ErrorCode::kCorrupt, "a project is a file, this is not one").at(path.string()));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return tl::unexpected(
        Error(ErrorCode::kIo, fmt::format("the project cannot be read ({})", std::strerror(errno))).at(path.string()));
  }
  Header header{};
  file.read(reinterpret_cast<char*>(header.data()), kHeaderSize);
  Status checked = file ? check_bytes(header, size_or_zero(path), size_or_zero(log_of(path)) > 0)
                        : Status(fail(ErrorCode::kCorrupt, "the file is too short to be a Trocar project"));
  if (!checked) return tl::unexpected(std::move(checked).error().at(path.string()));
  return {};
}

}  // namespace trocar::store
