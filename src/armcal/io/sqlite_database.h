// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace armcal {

/// What SQLite refused, with its result code (sqlite.org/rescode.html).
class SqliteError : public std::runtime_error {
 public:
  SqliteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] int code() const { return code_; }  ///< primary, without the extended bits

 private:
  int code_;
};

/// A prepared statement. Parameters count from 1, columns from 0, as in SQLite.
class SqliteStatement {
 public:
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, std::string_view value);
  void bind(int parameter, const std::optional<double>& value);  ///< nothing is NULL
  /// Goes to the next row. @return nothing left
  bool step();
  /// Makes it ready to be run again with other values.
  void reset();

  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::optional<double> number(int column) const;

 private:
  friend class SqliteDatabase;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  SqliteStatement(sqlite3* database, sqlite3_stmt* statement)
      : database_(database), statement_(statement) {}
  void check(int code) const;

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A connection to an SQLite file. Everything throws SqliteError.
class SqliteDatabase {
 public:
  enum class Missing { refuse, create };

  /// @param path     of a file, whatever it looks like
  /// @param missing  what to do where there is none
  SqliteDatabase(const std::string& path, Missing missing);

  void execute(const std::string& sql);
  [[nodiscard]] SqliteStatement prepare(std::string_view sql);
  /// The integer that a query gives in its first row.
  [[nodiscard]] std::int64_t integer(std::string_view sql);
  /// Of the row that was inserted last.
  [[nodiscard]] std::int64_t last_id() const;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

/// All or nothing: what is not committed is undone. Takes the right to write at once, waiting for
/// others who have it.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  SqliteDatabase& database_;
  bool open_ = true;
};

}  // namespace armcal
