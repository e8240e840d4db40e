// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/check_history.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "armcal/core/diagnostics.h"

namespace armcal {
namespace {

using namespace std::string_view_literals;

constexpr int kSchemaVersion = 1;
constexpr std::int64_t kApplicationId = 0x61726D63;  // "armc"

// Checks and their values are two tables, because new kinds of check bring new values.
constexpr const char* kTables = R"sql(
CREATE TABLE checks (
  id              INTEGER PRIMARY KEY AUTOINCREMENT,
  time_utc        TEXT NOT NULL,
  arm             TEXT NOT NULL,
  arm_sha256      TEXT NOT NULL,
  artefact        TEXT NOT NULL,
  kind            TEXT NOT NULL,
  point_count     INTEGER NOT NULL,
  temperature_c   REAL,
  verdict         TEXT NOT NULL,
  readings_sha256 TEXT NOT NULL,
  tool_version    TEXT NOT NULL,
  note            TEXT NOT NULL
) STRICT;
CREATE TABLE check_values (
  check_id INTEGER NOT NULL REFERENCES checks (id),
  position INTEGER NOT NULL,
  name     TEXT NOT NULL,
  value_mm REAL NOT NULL,
  limit_mm REAL,
  PRIMARY KEY (check_id, name)
) STRICT, WITHOUT ROWID;
CREATE TRIGGER checks_stay BEFORE UPDATE ON checks
  BEGIN SELECT RAISE(ABORT, 'a history of checks is only appended to'); END;
CREATE TRIGGER checks_are_kept BEFORE DELETE ON checks
  BEGIN SELECT RAISE(ABORT, 'a history of checks is only appended to'); END;
CREATE TRIGGER check_values_stay BEFORE UPDATE ON check_values
  BEGIN SELECT RAISE(ABORT, 'a history of checks is only appended to'); END;
CREATE TRIGGER check_values_are_kept BEFORE DELETE ON check_values
  BEGIN SELECT RAISE(ABORT, 'a history of checks is only appended to'); END;
)sql";

[[noreturn]] void refuse(const std::string& path, std::string message, std::string remedy) {
  Diagnostics diagnostics;
  diagnostics.error({path, 0, 0}, std::move(message), std::move(remedy));
  throw InputError(diagnostics);
}

[[noreturn]] void rethrow(const SqliteError& error, const std::string& path) {
  switch (error.code()) {
    case SQLITE_NOTADB:
      refuse(path, "is no history of checks", "choose another file; a new one is made");
    case SQLITE_BUSY:
      throw FileError(fmt::format(
          "{}: another program keeps the history busy\n  help: close it and try again", path));
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      throw FileError(
          fmt::format("{}: cannot write the history there ({})\n  help: it is kept in the file and "
                      "in two beside it (-wal, -shm): choose a folder that exists and that you may "
                      "write in",
                      path, error.what()));
    case SQLITE_FULL:
      throw FileError(fmt::format("{}: no space left for the history", path));
    case SQLITE_CORRUPT:
      throw FileError(fmt::format(
          "{}: the history is damaged ({})\n  help: go back to a copy, or save what is readable: "
          "sqlite3 FILE .recover",
          path, error.what()));
    default:
      throw FileError(fmt::format("{}: {}", path, error.what()));
  }
}

// Runs something on a file and words what may go wrong.
template <class Action>
auto on_file(const std::string& path, const Action& action) {
  try {
    return action();
  } catch (const SqliteError& error) {
    rethrow(error, path);
  }
}

// What SQLite would only find out after it has touched the file.
void check_path(const std::string& path, CheckHistory::Missing missing) {
  if (path.empty() || path == "-") {
    refuse("history", "must be a file, not a stream", "name one: --history checks.db");
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    refuse(path, "is a folder", "name a file in it: --history " + path + "/checks.db");
  }
  if (!std::filesystem::exists(path, ignored)) {
    if (missing == CheckHistory::Missing::create) return;
    refuse(path, "does not exist", "the first check that is saved makes it");
  }
  if (!std::filesystem::is_regular_file(path, ignored)) refuse(path, "is no file", "");
  std::array<char, 16> head{};
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head.size());
  const std::string_view read(head.data(), static_cast<std::size_t>(file.gcount()));
  if (!read.empty() && read != "SQLite format 3\0"sv) {
    refuse(path, "is no history of checks", "choose another file; a new one is made");
  }
}

// Two programs that make the same file at once: SQLite tells one of them that it is busy without
// waiting.
void use_write_ahead_log(SqliteDatabase& database) {
  constexpr int kAttempts = 200;
  for (int attempt = 1;; ++attempt) {
    try {
      database.execute("PRAGMA journal_mode = WAL");
      return;
    } catch (const SqliteError& error) {
      if (error.code() != SQLITE_BUSY || attempt == kAttempts) throw;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

// Is there nothing in it yet? So a file is left by who was killed while making it.
bool is_new(SqliteDatabase& database) {
  return database.integer("SELECT count(*) FROM sqlite_schema") == 0 &&
         database.integer("PRAGMA user_version") == 0;
}

void create_tables(SqliteDatabase& database) {
  SqliteTransaction transaction(database);
  if (!is_new(database)) return;  // another program was first
  database.execute(kTables);
  database.execute(fmt::format("PRAGMA application_id = {}", kApplicationId));
  database.execute(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
  transaction.commit();
}

void check_version(SqliteDatabase& database, const std::string& path) {
  if (database.integer("PRAGMA application_id") != kApplicationId) {
    refuse(path, "is an SQLite file, but no history of checks",
           "choose another file; a new one is made");
  }
  const std::int64_t version = database.integer("PRAGMA user_version");
  if (version > kSchemaVersion) {
    refuse(path,
           fmt::format("was written by a newer armcal (history version {}, known up to {})",
                       version, kSchemaVersion),
           "use that one");
  }
}

std::int64_t insert_check(SqliteDatabase& database, const CheckRecord& check) {
  SqliteStatement row = database.prepare(
      "INSERT INTO checks (time_utc, arm, arm_sha256, artefact, kind, point_count, "
      "temperature_c, verdict, readings_sha256, tool_version, note) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  int at = 0;
  row.bind(++at, utc_text(check.time));
  for (const std::string& text : {check.arm, check.arm_sha256, check.artefact, check.kind}) {
    row.bind(++at, text);
  }
  row.bind(++at, check.point_count);
  row.bind(++at, check.temperature_c);
  for (const std::string& text :
       {check.verdict, check.readings_sha256, check.tool_version, check.note}) {
    row.bind(++at, text);
  }
  row.step();
  return database.last_id();
}

void insert_values(SqliteDatabase& database, std::int64_t id,
                   const std::vector<CheckedValue>& values) {
  SqliteStatement row = database.prepare(
      "INSERT INTO check_values (check_id, position, name, value_mm, limit_mm) "
      "VALUES (?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const CheckedValue& each : values) {
    row.bind(1, id);
    row.bind(2, ++position);
    row.bind(3, each.name);
    row.bind(4, std::optional(each.value_mm));
    row.bind(5, each.limit_mm);
    row.step();
    row.reset();
  }
}

}  // namespace

CheckHistory::CheckHistory(std::string path, Missing missing) : path_(std::move(path)) {
  check_path(path_, missing);
  on_file(path_, [&] {
    database_.emplace(path_, missing == Missing::create ? SqliteDatabase::Missing::create
                                                        : SqliteDatabase::Missing::refuse);
    // Flushed at every commit: the default of a write-ahead log may lose the last ones when the
    // power goes.
    database_->execute("PRAGMA synchronous = FULL");
    database_->execute("PRAGMA foreign_keys = ON");
    if (is_new(*database_)) {
      if (missing == Missing::refuse) refuse(path_, "holds no check yet", "");
      use_write_ahead_log(*database_);
      create_tables(*database_);
    }
    check_version(*database_, path_);
  });
}

std::int64_t CheckHistory::append(const CheckRecord& check) {
  return on_file(path_, [&] {
    SqliteTransaction transaction(*database_);
    const std::int64_t id = insert_check(*database_, check);
    insert_values(*database_, id, check.values);
    transaction.commit();
    return id;
  });
}

std::vector<CheckRecord> CheckHistory::checks() {
  return on_file(path_, [&] {
    std::vector<CheckRecord> checks;
    SqliteStatement row = database_->prepare(
        "SELECT id, time_utc, arm, arm_sha256, artefact, kind, point_count, temperature_c, "
        "verdict, readings_sha256, tool_version, note, name, value_mm, limit_mm "
        "FROM checks LEFT JOIN check_values ON check_id = id ORDER BY time_utc, id, position");
    while (row.step()) {
      if (checks.empty() || checks.back().id != row.integer(0)) {
        const auto time = parse_utc_time(row.text(1));
        if (!time) {
          refuse(path_, fmt::format("check {}: \"{}\" is no time", row.integer(0), row.text(1)),
                 "was the file changed by other means?");
        }
        checks.push_back({row.integer(0),
                          *time,
                          row.text(2),
                          row.text(3),
                          row.text(4),
                          row.text(5),
                          row.integer(6),
                          row.number(7),
                          row.text(8),
                          row.text(9),
                          row.text(10),
                          row.text(11),
                          {}});
      }
      if (const auto value_mm = row.number(13))
        checks.back().values.push_back({row.text(12), *value_mm, row.number(14)});
    }
    return checks;
  });
}

}  // namespace armcal
