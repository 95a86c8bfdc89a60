#include "engine/store/database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstring>

namespace trocar::store {
namespace {

constexpr int kPatience_ms = 500;

/// `system` is the reason that the system gave, 0 if none.
Error describe(int code, const char* detail, int system) {
  const std::string why = system == 0 ? "" : fmt::format(" ({})", std::strerror(system));
  switch (code & 0xFF) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorCode::kIo, "the project is open in another program that is writing to it"};
    case SQLITE_NOTADB:
      return {ErrorCode::kCorrupt, "the file is not a Trocar project"};
    case SQLITE_CORRUPT:
      return {ErrorCode::kCorrupt, "the project is damaged"};
    case SQLITE_ERROR:
      return {ErrorCode::kCorrupt, fmt::format("the project's tables are not as they should be ({})", detail)};
    case SQLITE_FULL:
      return {ErrorCode::kIo, "the disk is full"};
    case SQLITE_READONLY:
      return {ErrorCode::kIo, "the project cannot be written, its file or folder is read-only"};
    case SQLITE_CANTOPEN:
      return {ErrorCode::kIo, "the project cannot be opened, its file or folder is not accessible" + why};
    case SQLITE_IOERR:
      return {ErrorCode::kIo, "the project's disk cannot be read or written, or is full" + why};
    default:
      return {ErrorCode::kIo, fmt::format("the project file fails ({})", detail)};
  }
}

int bind(sqlite3_stmt* statement, int index, const Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return sqlite3_bind_int64(statement, index, *number);
  if (const auto* text = std::get_if<std::string_view>(&value)) {
    return sqlite3_bind_text64(statement, index, text->data() == nullptr ? "" : text->data(), text->size(),
                               SQLITE_STATIC, SQLITE_UTF8);
  }
  const std::string_view bytes = std::get<Blob>(value).bytes;
  // A null pointer would bind NULL in place of an empty blob.
  return sqlite3_bind_blob64(statement, index, bytes.data() == nullptr ? "" : bytes.data(), bytes.size(),
                             SQLITE_STATIC);
}

/// As SQLite's file: names want it.
std::string escaped(std::string_view path) {
  std::string text;
  for (const char c : path) {
    const bool plain = c != '%' && c != '?' && c != '#';
    text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return text;
}

/// Lets go of the bound values and of the read lock on every path out.
class Use {
 public:
  explicit Use(sqlite3_stmt* statement) : statement_(statement) {}
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use() {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }

 private:
  sqlite3_stmt* statement_;
};

}  // namespace

std::int64_t Row::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

std::string_view Row::bytes(int column) const {
  const void* data = sqlite3_column_blob(statement_, column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  return data == nullptr ? std::string_view() : std::string_view(static_cast<const char*>(data), size);
}

void Database::Close::operator()(sqlite3* connection) const {
  sqlite3_close_v2(connection);
}

void Database::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Result<Database> Database::open(const std::filesystem::path& path, Access access) {
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  const bool writes = access == Access::kCreate || access == Access::kWrite;
  flags |= writes ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY;
  if (access == Access::kCreate) flags |= SQLITE_OPEN_CREATE;
  std::string name = path.string();
  if (access == Access::kImmutable) {
    flags |= SQLITE_OPEN_URI;
    name = "file:" + escaped(name) + "?immutable=1";
  }
  sqlite3* connection = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &connection, flags, nullptr);
  Database database(connection, path);
  if (code != SQLITE_OK) return database.failure(code);
  database.set_patience_ms(kPatience_ms);
  sqlite3_db_config(connection, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(connection, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return database;
}

tl::unexpected<Error> Database::failure(int code) const {
  const char* detail = connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(code);
  held_elsewhere_ = (code & 0xFF) == SQLITE_BUSY;
  const int system = connection_ ? sqlite3_system_errno(connection_.get()) : 0;
  return tl::unexpected(describe(code, detail, system).at(path_.string()));
}

Status Database::execute(const char* sql) {
  const int code = sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) return failure(code);
  return {};
}

Result<sqlite3_stmt*> Database::prepare(std::string_view sql, std::initializer_list<Value> values) {
  auto found = statements_.find(std::string(sql));
  if (found == statements_.end()) {
    sqlite3_stmt* compiled = nullptr;
    const int code = sqlite3_prepare_v3(connection_.get(), sql.data(), static_cast<int>(sql.size()),
                                        SQLITE_PREPARE_PERSISTENT, &compiled, nullptr);
    if (code != SQLITE_OK) return failure(code);
    found = statements_.emplace(sql, compiled).first;
  }
  sqlite3_stmt* statement = found->second.get();
  int index = 0;
  for (const Value& value : values) {
    const int code = bind(statement, ++index, value);
    if (code != SQLITE_OK) return failure(code);
  }
  return statement;
}

Status Database::query(std::string_view sql, std::initializer_list<Value> values,
                       const std::function<Status(const Row&)>& visit) {
  TROCAR_ASSIGN_OR_RETURN(sqlite3_stmt * statement, prepare(sql, values));
  const Use use(statement);
  for (;;) {
    const int code = sqlite3_step(statement);
    if (code == SQLITE_DONE) {
      held_elsewhere_ = false;
      return {};
    }
    if (code != SQLITE_ROW) return failure(code);
    TROCAR_RETURN_IF_ERROR(visit(Row(statement)));
  }
}

Status Database::run(std::string_view sql, std::initializer_list<Value> values) {
  return query(sql, values, [](const Row&) { return Status(); });
}

Result<std::int64_t> Database::integer(std::string_view sql, std::initializer_list<Value> values,
                                       std::int64_t missing) {
  bool first = true;
  TROCAR_RETURN_IF_ERROR(query(sql, values, [&](const Row& row) {
    if (first) missing = row.integer(0);
    first = false;
    return Status();
  }));
  return missing;
}

void Database::set_patience_ms(int patience_ms) {
  sqlite3_busy_timeout(connection_.get(), patience_ms);
}

std::int64_t Database::last_id() const {
  return sqlite3_last_insert_rowid(connection_.get());
}

int Database::changes() const {
  return sqlite3_changes(connection_.get());
}

bool Database::in_transaction() const {
  return sqlite3_get_autocommit(connection_.get()) == 0;
}

}  // namespace trocar::store
