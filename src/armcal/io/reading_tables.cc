// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/reading_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "armcal/core/spelling.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

// A joint of a measuring arm may turn more than once, but not more than this; degrees are mostly
// larger.
constexpr double kLargestAngle_rad = 2.0 * std::numbers::pi + 1e-9;
constexpr double kLargestAngle_deg = 720.0;

struct Unit {
  std::string_view name;
  double factor;
};
constexpr std::array<Unit, 7> kLengths = {{{"mm", 1.0},
                                           {"m", 1000.0},
                                           {"cm", 10.0},
                                           {"um", 0.001},
                                           {"\xC2\xB5m", 0.001},
                                           {"in", 25.4},
                                           {"inch", 25.4}}};

// Says what is missing, what is there and how to map it.
void complain_of_missing(const CsvTable& table, const std::vector<std::string>& names,
                         Diagnostics& diagnostics) {
  if (names.empty()) return;
  const bool one = names.size() == 1;
  const char* mapped = table.has_header() ? "HEADER" : "NUMBER";
  diagnostics.error(
      {table.file().path, 0, 0},
      fmt::format("has no column{} {}", one ? "" : "s", fmt::join(names, ", ")),
      fmt::format("{}; name the right {} with --map {}={}", table.columns_in_words(),
                  one ? "one" : "ones", fmt::join(names, fmt::format("={},", mapped)), mapped));
}

// A column that must be there.
std::optional<std::size_t> required(const CsvTable& table, const std::string& name,
                                    std::string_view suffix, Diagnostics& diagnostics) {
  const auto column = table.find(name);
  if (!column) complain_of_missing(table, {fmt::format("{}{}", name, suffix)}, diagnostics);
  return column;
}

std::optional<double> length_factor(const CsvTable& table, std::size_t column,
                                    Diagnostics& diagnostics) {
  const CsvColumn& at = table.columns()[column];
  for (const Unit& unit : kLengths) {
    if (at.unit == unit.name) return unit.factor;
  }
  diagnostics.error({table.file().path, 0, 0},
                    at.unit.empty() ? fmt::format("{} has no unit", table.column_in_words(column))
                                    : fmt::format("{}: {} is no unit of length",
                                                  table.column_in_words(column), at.unit),
                    fmt::format("name it {}_mm, or give --map {}_mm={}", at.name, at.name,
                                at.header.empty() ? std::to_string(column + 1) : at.header));
  return std::nullopt;
}

std::vector<double> lengths(const CsvTable& table, std::size_t column, std::string_view quantity,
                            double factor, Diagnostics& diagnostics) {
  std::vector<double> values = table.numbers(column, quantity, diagnostics);
  if (factor != 1.0) {
    for (double& value : values) value *= factor;
  }
  return values;
}

// Unit of an angle column: the header's, or what the user says.
std::optional<AngleUnit> angle_unit(const CsvTable& table, std::size_t column,
                                    const TableOptions& options, Diagnostics& diagnostics) {
  const CsvColumn& at = table.columns()[column];
  std::optional<AngleUnit> by_header;
  if (at.unit == "deg" || at.unit == "\xC2\xB0") by_header = AngleUnit::deg;
  if (at.unit == "rad") by_header = AngleUnit::rad;
  if (options.angles) {
    if (by_header && *by_header != *options.angles) {
      diagnostics.warning({table.file().path, 0, 0},
                          fmt::format("{} is read in {} as you asked, against its name",
                                      table.column_in_words(column),
                                      *options.angles == AngleUnit::deg ? "degrees" : "radians"));
    }
    return options.angles;
  }
  if (by_header) return by_header;
  diagnostics.error({table.file().path, 0, 0},
                    at.unit.empty() ? fmt::format("{} has no unit", table.column_in_words(column))
                                    : fmt::format("{}: {} is no unit of angle",
                                                  table.column_in_words(column), at.unit),
                    "give --angles deg or --angles rad, or name the column q1_deg, q2_deg, ..");
  return std::nullopt;
}

double radians(double value, AngleUnit unit) {
  return unit == AngleUnit::deg ? radians_from_degrees(value) : value;
}

void check_size(const CsvTable& table, std::size_t column, int joint, AngleUnit unit,
                const std::vector<double>& values, Diagnostics& diagnostics) {
  const double largest = unit == AngleUnit::rad ? kLargestAngle_rad : kLargestAngle_deg;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(std::abs(values[row]) > largest)) continue;
    const std::string_view text = table.field(row, column);
    if (unit == AngleUnit::rad) {
      diagnostics.error(
          table.where(row, column),
          fmt::format("joint {} angle {} looks like degrees but the column is in radians", joint,
                      text),
          "give --angles deg if it is in degrees; else reduce the angle by full turns");
    } else {
      diagnostics.error(table.where(row, column),
                        fmt::format("joint {} angle {} deg is more than two turns", joint, text),
                        "are these encoder counts? convert them to degrees");
    }
    return;  // one per column says it
  }
}

// Angles that never leave +-2 pi in any of many rows were most likely meant in radians.
void warn_of_radians_as_degrees(const CsvTable& table, const JointReadings& readings,
                                Diagnostics& diagnostics) {
  constexpr Eigen::Index kManyRows = 10;
  if (readings.count() < kManyRows) return;
  if (degrees_from_radians(readings.encoder_rad.cwiseAbs().maxCoeff()) > 2.0 * std::numbers::pi)
    return;
  diagnostics.warning({table.file().path, 0, 0},
                      "all angles lie within +-6.3 degrees: are they radians?",
                      "give --angles rad if they are");
}

std::vector<int> lines_of(const CsvTable& table) {
  std::vector<int> lines;
  lines.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) lines.push_back(table.line(row));
  return lines;
}

// Joint j is in column columns[j - 1].
std::optional<std::vector<std::size_t>> joint_columns(const CsvTable& table, int joint_count,
                                                      const TableOptions& options,
                                                      Diagnostics& diagnostics) {
  std::vector<std::size_t> columns;
  const bool nameless = !table.has_header() && options.map.empty();
  if (nameless) {
    if (static_cast<int>(table.columns().size()) != joint_count) {
      diagnostics.error(
          {table.file().path, 0, 0},
          fmt::format("has no header and {} columns, the arm has {} joints", table.columns().size(),
                      joint_count),
          "add a header q1_deg,q2_deg,.. or map columns by number: --map q1_deg=1,q2_deg=2,..");
      return std::nullopt;
    }
    for (std::size_t c = 0; c < table.columns().size(); ++c) columns.push_back(c);
    return columns;
  }
  std::vector<std::string> missing;
  for (int joint = 1; joint <= joint_count; ++joint) {
    const std::string name = fmt::format("q{}", joint);
    if (const auto column = table.find(name)) {
      columns.push_back(*column);
    } else {
      missing.push_back(name + "_deg");
    }
  }
  complain_of_missing(table, missing, diagnostics);
  bool complete = missing.empty();
  if (table.find(fmt::format("q{}", joint_count + 1))) {
    diagnostics.error(
        {table.file().path, 0, 0},
        fmt::format("has a column q{} but the arm has {} joints", joint_count + 1, joint_count),
        "is it a file of another arm?");
    complete = false;
  }
  if (!complete) return std::nullopt;
  return columns;
}

void check_duplicates(const CsvTable& table, const std::vector<Eigen::Vector3d>& points,
                      Diagnostics& diagnostics) {
  // Sorted, equal points stand together, each group in the order of the file.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t row) {
    const Eigen::Vector3d& p = points[row];
    return std::tuple(p.x(), p.y(), p.z(), row);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t one, std::size_t other) { return key(one) < key(other); });
  std::vector<std::pair<std::size_t, std::size_t>> repeats;  // row, and the first one like it
  std::size_t first = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (points[order[i]] == points[order[first]]) {
      repeats.emplace_back(order[i], order[first]);
    } else {
      first = i;
    }
  }
  std::sort(repeats.begin(), repeats.end());
  for (const auto& [row, original] : repeats) {
    diagnostics.error({table.file().path, table.line(row), 0},
                      fmt::format("repeats the point of line {}", table.line(original)),
                      "delete it, or give --keep-duplicates if it was measured twice");
  }
}

// Whole rows, as written: a clock or a counter beside equal readings makes them different ones.
void check_duplicate_rows(const CsvTable& table, Diagnostics& diagnostics) {
  const std::size_t last = table.columns().size() - 1;
  std::unordered_map<std::string_view, int> first_lines;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string_view begin = table.field(row, 0);
    const std::string_view end = table.field(row, last);
    const std::string_view text(begin.data(),
                                static_cast<std::size_t>(end.data() + end.size() - begin.data()));
    const auto [first, is_new] = first_lines.emplace(text, table.line(row));
    if (is_new) continue;
    diagnostics.error({table.file().path, table.line(row), 0},
                      fmt::format("is the same as line {}", first->second),
                      "delete it, or give --keep-duplicates if it was measured twice");
  }
}

void check_zero_points(const CsvTable& table, const std::vector<Eigen::Vector3d>& points,
                       Diagnostics& diagnostics) {
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (!points[row].isZero(0.0)) continue;
    diagnostics.error({table.file().path, table.line(row), 0},
                      "the point 0 0 0 looks like a missing one",
                      "delete the row, or give --keep-zero-points if the point is real");
  }
}

// Coordinates from columns x, y, z; `planar` allows z to be absent.
std::optional<std::vector<Eigen::Vector3d>> coordinates(const CsvTable& table, bool& planar,
                                                        Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  std::array<std::vector<double>, 3> xyz;
  std::vector<std::string> missing;
  constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
  planar = planar && !table.find("z");
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == 2 && planar) {
      xyz[k].assign(table.row_count(), 0.0);
      continue;
    }
    const auto column = table.find(kNames[k]);
    if (!column) {
      missing.push_back(fmt::format("{}_mm", kNames[k]));
      continue;
    }
    const auto factor = length_factor(table, *column, diagnostics);
    if (!factor) continue;
    xyz[k] = lengths(table, *column, fmt::format("{} coordinate", kNames[k]), *factor, diagnostics);
  }
  complain_of_missing(table, missing, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  std::vector<Eigen::Vector3d> points;
  points.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    points.emplace_back(xyz[0][row], xyz[1][row], xyz[2][row]);
  }
  return points;
}

// Gives the columns of a table without header the names x, y, z in mm.
std::optional<CsvTable> with_coordinate_names(const CsvTable& table, Diagnostics& diagnostics) {
  const std::size_t count = table.columns().size();
  ColumnMap map = {{"x_mm", "1"}, {"y_mm", "2"}};
  if (count == 3) map.emplace("z_mm", "3");
  diagnostics.warning({table.file().path, 0, 0},
                      fmt::format("has no header: its {} columns are taken as {}", count,
                                  count == 3 ? "x_mm,y_mm,z_mm" : "x_mm,y_mm"));
  return CsvTable::parse(table.file(), map, diagnostics);
}

}  // namespace

std::optional<JointReadings> joint_readings(const CsvTable& table, int joint_count,
                                            const TableOptions& options, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto columns = joint_columns(table, joint_count, options, diagnostics);
  if (!columns) return std::nullopt;
  JointReadings readings;
  readings.file = table.file().path;
  readings.encoder_rad.resize(joint_count, static_cast<Eigen::Index>(table.row_count()));
  bool in_degrees = false;
  for (int joint = 1; joint <= joint_count; ++joint) {
    const std::size_t column = (*columns)[static_cast<std::size_t>(joint - 1)];
    const auto unit = angle_unit(table, column, options, diagnostics);
    if (!unit) return std::nullopt;
    const auto values = table.numbers(column, fmt::format("joint {} angle", joint), diagnostics);
    check_size(table, column, joint, *unit, values, diagnostics);
    for (std::size_t row = 0; row < values.size(); ++row) {
      readings.encoder_rad(joint - 1, static_cast<Eigen::Index>(row)) = radians(values[row], *unit);
    }
    in_degrees = in_degrees || *unit == AngleUnit::deg;
  }
  if (!options.keep_duplicates) check_duplicate_rows(table, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  if (in_degrees) warn_of_radians_as_degrees(table, readings, diagnostics);
  readings.lines = lines_of(table);
  return readings;
}

std::optional<PointReadings> point_readings(const CsvTable& given, const TableOptions& options,
                                            Diagnostics& diagnostics) {
  const CsvTable* table = &given;
  std::optional<CsvTable> named;
  const std::size_t count = given.columns().size();
  if (!given.has_header() && options.map.empty() && (count == 2 || count == 3)) {
    named = with_coordinate_names(given, diagnostics);
    if (!named) return std::nullopt;
    table = &*named;
  }
  const std::size_t errors_before = diagnostics.error_count();
  PointReadings readings;
  readings.file = table->file().path;
  readings.planar = true;
  auto points = coordinates(*table, readings.planar, diagnostics);
  if (!points) return std::nullopt;
  readings.points_mm = std::move(*points);
  if (!options.keep_duplicates) check_duplicates(*table, readings.points_mm, diagnostics);
  if (!options.keep_zero_points && !readings.planar) {
    check_zero_points(*table, readings.points_mm, diagnostics);
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  readings.lines = lines_of(*table);
  if (const auto names = table->find("point")) {
    for (std::size_t row = 0; row < table->row_count(); ++row) {
      readings.names.emplace_back(table->field(row, *names));
    }
  }
  return readings;
}

std::optional<CsvTable> rows_of_reading(const CsvTable& table, const std::string& name,
                                        Diagnostics& diagnostics) {
  const auto column = table.find("reading");
  if (!column) return table;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    if (table.field(row, *column) == name) rows.push_back(row);
  }
  if (rows.empty()) {
    diagnostics.error({table.file().path, 0, 0},
                      fmt::format("has no rows of reading \"{}\"", name));
    return std::nullopt;
  }
  return table.with_rows(rows);
}

std::optional<RawSymmetricPoints> symmetric_points(const CsvTable& table,
                                                   const SymmetricReading& reading, int joint_count,
                                                   const TableOptions& options,
                                                   Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  RawSymmetricPoints raw;
  raw.file = table.file().path;
  bool planar = false;
  auto points = coordinates(table, planar, diagnostics);
  if (points && !options.keep_zero_points) check_zero_points(table, *points, diagnostics);
  if (!options.keep_duplicates) check_duplicate_rows(table, diagnostics);

  const auto end = reading.kind == SymmetricKind::reversal ? required(table, "end", "", diagnostics)
                                                           : table.find("end");
  if (end && reading.kind != SymmetricKind::circle_radius) {
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const std::string_view text = table.field(row, *end);
      const bool is_a = text == "A" || text == "a" || text == "P";
      const bool is_b = text == "B" || text == "b" || text == "P'";
      if (!is_a && !is_b) {
        diagnostics.error(table.where(row, *end),
                          fmt::format("end \"{}\" is neither A nor B", text));
      }
      raw.end.push_back(is_a ? 'A' : 'B');
    }
  }
  if (table.find("q1")) {
    TableOptions angle_options = options;
    angle_options.keep_duplicates = true;  // told above
    const auto angles = joint_readings(table, joint_count, angle_options, diagnostics);
    if (angles) raw.encoder_rad = angles->encoder_rad;
  }
  if (reading.kind == SymmetricKind::zero_search) {
    const auto column = required(table, fmt::format("q{}", reading.joint), "_deg", diagnostics);
    const auto unit = column ? angle_unit(table, *column, options, diagnostics) : std::nullopt;
    if (unit) {
      const auto values =
          table.numbers(*column, fmt::format("joint {} angle", reading.joint), diagnostics);
      check_size(table, *column, reading.joint, *unit, values, diagnostics);
      for (const double value : values) {
        raw.setting_rad.push_back(radians(value, *unit));
      }
    }
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  raw.points_mm = std::move(*points);
  raw.lines = lines_of(table);
  return raw;
}

}  // namespace armcal
