// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/core/utc_time.h"
#include "armcal/io/sqlite_database.h"

namespace armcal {

/// One number that a check gave.
struct CheckedValue {
  std::string name;  ///< max_deviation, length_error, ..
  double value_mm = 0.0;
  std::optional<double> limit_mm;

  friend bool operator==(const CheckedValue&, const CheckedValue&) = default;
};

/// One interim check as it is kept.
struct CheckRecord {
  std::int64_t id = 0;  ///< from 1, given by the history
  UtcSeconds time = 0;
  std::string arm;         ///< name or serial number
  std::string arm_sha256;  ///< of the arm file; empty where the readings were coordinates
  std::string artefact;
  std::string kind;  ///< seat, sphere
  std::int64_t point_count = 0;
  std::optional<double> temperature_c;
  std::string verdict;
  std::string readings_sha256;
  std::string tool_version;
  std::string note;
  std::vector<CheckedValue> values;
};

/// The interim checks of one or more arms in an SQLite file: append only (the file itself refuses
/// changes), write-ahead log, every transaction flushed to the device. docs/files/check-history.md
/// has the tables. Killed at any moment, the file opens and holds every check whose `append`
/// returned; several programs may append at once.
///
/// Everything throws InputError for what the user can mend (no history, of a newer version, no such
/// file to read), FileError where the device or another program is in the way.
class CheckHistory {
 public:
  enum class Missing {
    refuse,
    create,  ///< the file, with the first check
  };
  CheckHistory(std::string path, Missing missing);

  /// @return its number, once it is safe
  std::int64_t append(const CheckRecord& check);

  /// All of them, by time.
  [[nodiscard]] std::vector<CheckRecord> checks();

 private:
  std::string path_;
  std::optional<SqliteDatabase> database_;
};

}  // namespace armcal
