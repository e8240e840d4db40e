// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/dh_file.h"

#include <fmt/format.h>

#include <array>

#include "armcal/core/units.h"
#include "armcal/io/number_text.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

DhRow read_row(TomlSection section) {
  DhRow row;
  row.theta_rad = radians_from_degrees(section.number("theta_deg").value_or(0.0));
  row.d_mm = section.number("d_mm").value_or(0.0);
  row.a_mm = section.number("a_mm").value_or(0.0);
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
  if (position) pose.translation_mm = *position;
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
  for (TomlSection& section : root.sections("row")) table.rows.push_back(read_row(section));
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
  struct Column {
    const char* name;
    double DhRow::*member;
    bool is_angle;
  };
  constexpr std::array<Column, 4> kColumns = {{{"theta", &DhRow::theta_rad, true},
                                               {"d", &DhRow::d_mm, false},
                                               {"a", &DhRow::a_mm, false},
                                               {"alpha", &DhRow::alpha_rad, true}}};
  for (const Column& wanted : kColumns) {
    const char* unit = wanted.is_angle ? "deg" : "mm";
    const auto column = csv.find(wanted.name);
    if (!column) {
      diagnostics.error({csv.file().path, 0, 0},
                        fmt::format("has no column {}_{}", wanted.name, unit),
                        fmt::format("its columns: {}; name the right one with --map {}_{}=HEADER",
                                    csv.header_list(), wanted.name, unit));
      continue;
    }
    const std::string& given = csv.columns()[*column].unit;
    double factor = 0.0;
    if (given == "mm" || given == "rad") factor = 1.0;
    if (given == "m") factor = 1000.0;
    const bool in_degrees = given == "deg" || given == "\xC2\xB0";
    if (in_degrees) factor = 1.0;
    const bool right_kind = wanted.is_angle == (in_degrees || given == "rad");
    if (factor == 0.0 || !right_kind) {
      diagnostics.error({csv.file().path, 0, 0},
                        fmt::format("column {} needs a unit: {}_{}", csv.columns()[*column].header,
                                    wanted.name, unit));
      continue;
    }
    const auto values = csv.numbers(*column, wanted.name, diagnostics);
    for (std::size_t row = 0; row < values.size(); ++row) {
      table.rows[row].*wanted.member =
          in_degrees ? radians_from_degrees(values[row]) : factor * values[row];
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
