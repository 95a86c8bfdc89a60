/// One SQLite connection as the store uses it: statements by text, values bound in order, errors as sentences.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>

#include "engine/core/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace trocar::store {

/// Bytes that are bound as a BLOB, not as text.
struct Blob {
  std::string_view bytes;
};
using Value = std::variant<std::int64_t, std::string_view, Blob>;

/// The row that a query stands on; views die with the next row.
class Row {
 public:
  explicit Row(sqlite3_stmt* statement) : statement_(statement) {}
  std::int64_t integer(int column) const;
  std::string_view bytes(int column) const;
  std::string text(int column) const { return std::string(bytes(column)); }

 private:
  sqlite3_stmt* statement_;
};

/// Errors of all functions: kCorrupt (not a database, damaged, foreign tables), kIo (locked, full disk, not writable).
/// Threads: one at a time.
class Database {
 public:
  enum class Access { kCreate, kWrite, kReadOnly, kImmutable };
  static Result<Database> open(const std::filesystem::path& path, Access access);

  /// Several statements without parameters.
  Status execute(const char* sql);
  /// One statement that gives no rows. `sql` is compiled once and kept.
  Status run(std::string_view sql, std::initializer_list<Value> values = {});
  /// Calls `visit` for each row; an error that `visit` returns ends the query.
  Status query(std::string_view sql, std::initializer_list<Value> values,
               const std::function<Status(const Row&)>& visit);
  /// The first column of the first row, or `missing`.
  Result<std::int64_t> integer(std::string_view sql, std::initializer_list<Value> values, std::int64_t missing);

  /// How long a statement waits for other programs to finish writing; 500 ms to begin with.
  void set_patience_ms(int patience_ms);
  /// The last statement failed because another program is writing, and for no other reason.
  bool held_elsewhere() const { return held_elsewhere_; }

  std::int64_t last_id() const;
  /// Rows that the last `run` changed.
  int changes() const;
  bool in_transaction() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Database(sqlite3* connection, std::filesystem::path path) : connection_(connection), path_(std::move(path)) {}
  Result<sqlite3_stmt*> prepare(std::string_view sql, std::initializer_list<Value> values);
  tl::unexpected<Error> failure(int code) const;

  std::unique_ptr<sqlite3, Close> connection_;
  std::unordered_map<std::string, std::unique_ptr<sqlite3_stmt, Finalize>> statements_;
  std::filesystem::path path_;
  mutable bool held_elsewhere_ = false;
};

}  // namespace trocar::store
