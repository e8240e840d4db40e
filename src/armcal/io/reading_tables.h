// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "armcal/core/diagnostics.h"
#include "armcal/io/csv_table.h"
#include "armcal/observations/readings.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

enum class AngleUnit { deg, rad };

/// What a user may say about a table.
struct TableOptions {
  ColumnMap map;
  UnmatchedMap unmatched = UnmatchedMap::error;
  /// Unit of angle columns that name none; where the header names one, this overrules it with a
  /// warning.
  std::optional<AngleUnit> angles;
  bool keep_duplicates = false;   ///< equal rows are readings, not a copying mistake
  bool keep_zero_points = false;  ///< a point 0 0 0 is a point, not a missing one
};

/// Joint angles from the columns q1 .. qN (deg or rad). Strict where a mistake would be silent:
/// degrees in a column of radians, angles of more than two turns, missing columns and columns
/// beyond the last joint. A table without header has its columns taken in order where their number
/// is that of the joints and `angles` tells the unit. Rows that are equal in every field are errors
/// unless `options` keep them. Problems go to `diagnostics`; with errors
/// nothing is returned.
[[nodiscard]] std::optional<JointReadings> joint_readings(const CsvTable& table, int joint_count,
                                                          const TableOptions& options,
                                                          Diagnostics& diagnostics);

/// Points from the columns x, y and z (mm, m, cm, um or in); without z they are planar. A table of
/// two or three columns without header is taken as mm, with a warning. Equal rows and points at 0 0
/// 0 are errors unless `options` keep them. A column `point` gives their names.
[[nodiscard]] std::optional<PointReadings> point_readings(const CsvTable& table,
                                                          const TableOptions& options,
                                                          Diagnostics& diagnostics);

/// The rows of one reading in a table that several share: those whose column `reading` holds its
/// name; the whole table where there is no such column. An error where there are none.
[[nodiscard]] std::optional<CsvTable> rows_of_reading(const CsvTable& table,
                                                      const std::string& name,
                                                      Diagnostics& diagnostics);

/// Points of a raw symmetric-point reading: x y z; `end` (A or B) where the reading needs it; joint
/// angles where they were recorded, at least that of the searched joint for a zero search. Points
/// at 0 0 0 and equal rows are errors unless `options` keep them.
[[nodiscard]] std::optional<RawSymmetricPoints> symmetric_points(const CsvTable& table,
                                                                 const SymmetricReading& reading,
                                                                 int joint_count,
                                                                 const TableOptions& options,
                                                                 Diagnostics& diagnostics);

}  // namespace armcal
