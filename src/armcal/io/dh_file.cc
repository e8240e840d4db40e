// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/dh_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "armcal/core/units.h"
#include "armcal/io/number_text.h"
#include "armcal/io/plausibility.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

DhRow read_row(TomlSection section, Diagnostics& diagnostics) {
  DhRow row;
  row.theta_rad = radians_from_degrees(section.number("theta_deg").value_or(0.0));
  row.d_mm = length_or_zero(section, "d_mm", diagnostics);
  row.a_mm = length_or_zero(section, "a_mm", diagnostics);
  row.alpha_rad = radians_from_degrees(section.number("alpha_deg").value_or(0.0));
  section.finish();
  return row;
}

RigidTransform read_pose(TomlSection section, Diagnostics& diagnostics) {
  RigidTransform pose;
  const auto position = section.numbers("position_mm");
  const auto angles = section.numbers("orientation_deg");
  for (const auto& [key, numbers] :
       {std::pair{"position_mm", &position}, {"orientation_deg", &angles}}) {
    if (*numbers && (*numbers)->size() != 3) {
      diagnostics.error(section.where(key),
                        fmt::format("{} has {} numbers: must have 3", key, (*numbers)->size()));
      return pose;
    }
  }
  if (position) {
    pose.translation_mm = *position;
    for (const double length : *position) {
      checked_length(length, "position_mm", section.where("position_mm"), diagnostics);
    }
  }
  if (angles) {
    pose.rotation = rotation_from_roll_pitch_yaw(
        angles->unaryExpr([](double angle) { return radians_from_degrees(angle); }));
  }
  section.finish();
  return pose;
}

std::string pose_text(const char* name, const RigidTransform& pose) {
  if (pose.translation_mm.isZero(0.0) && pose.rotation.isIdentity(0.0)) return {};
  const Eigen::Vector3d& p = pose.translation_mm;
  const Eigen::Vector3d angles = roll_pitch_yaw_from_rotation(pose.rotation);
  return fmt::format("\n[{}]\nposition_mm = [{}, {}, {}]\norientation_deg = [{}, {}, {}]\n", name,
                     shortest_text(p.x()), shortest_text(p.y()), shortest_text(p.z()),
                     degrees_text(angles.x()), degrees_text(angles.y()), degrees_text(angles.z()));
}

void warn_of_radian_twists(const DhTable& table, const SourcePosition& where,
                           Diagnostics& diagnostics) {
  std::vector<double> twists_deg;
  for (const DhRow& row : table.rows) twists_deg.push_back(degrees_from_radians(row.alpha_rad));
  warn_of_radians(twists_deg, "the values of alpha_deg", where, diagnostics);
}

// One column of a spreadsheet: what it is called here and where it goes.
struct Column {
  const char* name;
  double DhRow::*member;
  bool is_angle;
};
constexpr std::array<Column, 4> kColumns = {{{"theta", &DhRow::theta_rad, true},
                                             {"d", &DhRow::d_mm, false},
                                             {"a", &DhRow::a_mm, false},
                                             {"alpha", &DhRow::alpha_rad, true}}};

// Factor from the unit of a column to mm or rad; nothing where it has none or one of another kind.
std::optional<double> factor_of(const CsvColumn& column, bool is_angle) {
  if (is_angle && column.unit == "rad") return 1.0;
  if (is_angle && (column.unit == "deg" || column.unit == "\xC2\xB0")) {
    return radians_from_degrees(1.0);
  }
  if (!is_angle && column.unit == "mm") return 1.0;
  if (!is_angle && column.unit == "m") return 1000.0;
  return std::nullopt;
}

// Angles of more than a turn in a column of radians are degrees.
void check_radians(const CsvTable& csv, std::size_t column, const std::vector<double>& values,
                   Diagnostics& diagnostics) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(std::abs(values[row]) > 2.0 * std::numbers::pi + 1e-9)) continue;
    diagnostics.error(csv.where(row, column),
                      fmt::format("{} {} looks like degrees but the column is in radians",
                                  csv.columns()[column].name, csv.field(row, column)),
                      "name the column .._deg if it is in degrees");
  }
}

void check_row_count(std::size_t count, const std::string& path, Diagnostics& diagnostics) {
  if (count >= kMinJoints && count <= kMaxJoints) return;
  diagnostics.error({path, 0, 0},
                    fmt::format("has {} row{}: an arm here has {} to {} joints", count,
                                count == 1 ? "" : "s", kMinJoints, kMaxJoints));
}

}  // namespace

std::optional<DhTable> read_dh(const TextFile& file, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  TomlSection root(*document, diagnostics);
  check_schema(root, "dh", diagnostics);
  DhTable table;
  table.name = root.text("name").value_or("");
  table.note = root.text("note").value_or("");
  if (const auto convention = root.required_text("convention")) {
    if (*convention != "classic" && *convention != "modified") {
      diagnostics.error(
          root.where("convention"),
          fmt::format("convention \"{}\" is neither \"classic\" nor \"modified\"", *convention));
    }
    table.convention = *convention == "modified" ? DhConvention::modified : DhConvention::classic;
  }
  for (TomlSection& section : root.sections("row")) {
    table.rows.push_back(read_row(section, diagnostics));
  }
  warn_of_radian_twists(table, {file.path, 0, 0}, diagnostics);
  if (auto section = root.section("base")) table.base_from_first = read_pose(*section, diagnostics);
  if (auto section = root.section("tool")) table.last_from_tool = read_pose(*section, diagnostics);
  root.finish();
  check_row_count(table.rows.size(), file.path, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return table;
}

std::optional<DhTable> dh_from_csv(const CsvTable& csv, DhConvention convention,
                                   Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  DhTable table;
  table.convention = convention;
  table.name = csv.file().path;
  table.rows.resize(csv.row_count());
  for (const Column& wanted : kColumns) {
    const char* unit = wanted.is_angle ? "deg" : "mm";
    const auto place = csv.find(wanted.name);
    if (!place) {
      diagnostics.error(
          {csv.file().path, 0, 0}, fmt::format("has no column {}_{}", wanted.name, unit),
          fmt::format("{}; name the right one with --map {}_{}={}", csv.columns_in_words(),
                      wanted.name, unit, csv.has_header() ? "HEADER" : "NUMBER"));
      continue;
    }
    const CsvColumn& column = csv.columns()[*place];
    const auto factor = factor_of(column, wanted.is_angle);
    if (!factor) {
      diagnostics.error(
          {csv.file().path, 0, 0},
          fmt::format("{} needs a unit: {}_{}", csv.column_in_words(*place), wanted.name, unit));
      continue;
    }
    const auto values = csv.numbers(*place, wanted.name, diagnostics);
    if (column.unit == "rad") check_radians(csv, *place, values, diagnostics);
    for (std::size_t row = 0; row < values.size(); ++row) {
      double& value = table.rows[row].*wanted.member;
      value = *factor * values[row];
      if (!wanted.is_angle && std::isfinite(value)) {
        checked_length(value, wanted.name, csv.where(row, *place), diagnostics);
      }
    }
    if (wanted.member == &DhRow::alpha_rad && column.unit != "rad") {
      warn_of_radian_twists(table, {csv.file().path, 0, 0}, diagnostics);
    }
  }
  check_row_count(table.rows.size(), csv.file().path, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return table;
}

std::string dh_text(const DhTable& table) {
  std::string text =
      fmt::format("schema = \"armcal.dh/1\"\nconvention = \"{}\"\n", to_string(table.convention));
  text += fmt::format("name = {}\n", toml_quoted(table.name));
  if (!table.note.empty()) text += fmt::format("note = {}\n", toml_quoted(table.note));
  text += pose_text("base", table.base_from_first);
  for (const DhRow& row : table.rows) {
    text += fmt::format("\n[[row]]\ntheta_deg = {}\nd_mm = {}\na_mm = {}\nalpha_deg = {}\n",
                        degrees_text(row.theta_rad), shortest_text(row.d_mm),
                        shortest_text(row.a_mm), degrees_text(row.alpha_rad));
  }
  return text + pose_text("tool", table.last_from_tool);
}

std::string dh_csv_text(const DhTable& table) {
  std::string text = "theta_deg,d_mm,a_mm,alpha_deg\n";
  for (const DhRow& row : table.rows) {
    text += fmt::format("{},{},{},{}\n", degrees_text(row.theta_rad), shortest_text(row.d_mm),
                        shortest_text(row.a_mm), degrees_text(row.alpha_rad));
  }
  return text;
}

}  // namespace armcal
