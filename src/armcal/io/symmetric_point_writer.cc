// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/symmetric_point_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>

#include "armcal/core/invariant.h"
#include "armcal/core/units.h"
#include "armcal/io/csv_text.h"
#include "armcal/io/number_text.h"
#include "armcal/io/text_file.h"
#include "armcal/io/toml_text.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

// "zero 6" is zero-6.
std::string file_stem(const std::string& name) {
  std::string stem;
  for (const char c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '_' || c == '.';
    if (is_plain) {
      stem += c;
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  while (!stem.empty() && (stem.back() == '-' || stem.back() == '.')) stem.pop_back();
  return stem.empty() || stem.front() == '.' ? "reading" + stem : stem;
}

std::string turn_text(const SymmetricReading& reading) {
  const bool has_both = reading.kind == SymmetricKind::reversal && reading.joint >= 1 &&
                        reading.joint <= reading.posture_rad.size() &&
                        reading.posture_end_rad.size() == reading.posture_rad.size();
  if (!has_both) return "";
  const Eigen::Index joint = reading.joint - 1;
  const double turn_rad = reading.posture_end_rad(joint) - reading.posture_rad(joint);
  constexpr double kRounding_rad = 1e-14;  // of the sum that the end is
  if (std::abs(turn_rad - std::numbers::pi) < kRounding_rad) return "";
  if (std::abs(turn_rad + std::numbers::pi) < kRounding_rad) return "turn_deg = -180\n";
  return fmt::format("turn_deg = {}\n", degrees_text(turn_rad));
}

std::string value_text(const SymmetricReading& reading) {
  switch (reading.kind) {
    case SymmetricKind::reversal:
      return fmt::format("distance_mm = {}\nu_mm = {}\n", shortest_text(reading.value),
                         shortest_text(reading.u));
    case SymmetricKind::circle_radius:
      return fmt::format("radius_mm = {}\nu_mm = {}\n", shortest_text(reading.value),
                         shortest_text(reading.u));
    case SymmetricKind::zero_search:
      break;
  }
  return fmt::format("angle_deg = {}\nu_deg = {}\n", degrees_text(reading.value),
                     degrees_text(reading.u));
}

std::string reading_text(const SymmetricReading& reading, const std::string& procedure_file) {
  std::string text = fmt::format("\n[[reading]]\nname = {}\nkind = \"{}\"\njoint = {}\n",
                                 toml_quoted(reading.name), to_string(reading.kind), reading.joint);
  const bool other_sweep =
      reading.kind == SymmetricKind::zero_search && reading.sweep != reading.joint - 1;
  if (other_sweep) text += fmt::format("sweep = {}\n", reading.sweep);
  if (reading.posture_rad.size() > 0) {
    text += fmt::format("posture_deg = {}\n", toml_degrees(reading.posture_rad));
  }
  text += turn_text(reading);
  if (!reading.reduced) {
    text +=
        fmt::format("file = {}\n", toml_quoted(path_to_write(procedure_file, reading.raw->file)));
    if (reading.u > 0.0) text += fmt::format("u_mm = {}\n", shortest_text(reading.u));
  } else {
    text += value_text(reading);
  }
  if (!reading.solves.empty()) text += fmt::format("solves = {}\n", toml_quoted(reading.solves));
  return text;
}

std::string adjust_text(const SymmetricPointProcedure& procedure) {
  const SymmetricPointProcedure usual;
  std::string text;
  if (!procedure.unknowns.empty()) text += "unknowns = " + toml_list(procedure.unknowns) + "\n";
  if (!procedure.hold.empty()) text += "hold = " + toml_list(procedure.hold) + "\n";
  if (procedure.significance != usual.significance) {
    text += fmt::format("significance = {}\n", shortest_text(procedure.significance));
  }
  if (procedure.power != usual.power) {
    text += fmt::format("power = {}\n", shortest_text(procedure.power));
  }
  return text.empty() ? "" : "\n[adjust]\n" + text;
}

std::string claims_text(const std::vector<Claim>& claims) {
  std::string text;
  std::optional<double> u_mm;
  std::optional<double> u_rad;
  for (const Claim& claim : claims) {
    const bool angle = is_angle_parameter(claim.parameter);
    std::optional<double>& u = angle ? u_rad : u_mm;
    if (u && *u != claim.u) {
      throw std::invalid_argument(fmt::format(
          "the claim of {} has another uncertainty than those before it", claim.parameter));
    }
    u = claim.u;
    text += toml_parameter(claim.parameter, claim.value) + "\n";
  }
  if (u_mm) text += fmt::format("u_mm = {}\n", shortest_text(*u_mm));
  if (u_rad) text += fmt::format("u_deg = {}\n", degrees_text(*u_rad));
  return text.empty() ? "" : "\n[claims]\n" + text;
}

bool any_row_repeats(const std::vector<std::string>& rows) {
  const std::set<std::string> distinct(rows.begin(), rows.end());
  return distinct.size() < rows.size();
}

}  // namespace

void name_point_files(SymmetricPointProcedure& procedure) {
  std::set<std::string> taken;
  for (const SymmetricReading& reading : procedure.readings) {
    if (reading.raw) taken.insert(reading.raw->file);
  }
  for (SymmetricReading& reading : procedure.readings) {
    if (reading.reduced) continue;
    if (!reading.raw) reading.raw = RawSymmetricPoints{};
    if (!reading.raw->file.empty()) continue;
    const std::string stem = file_stem(reading.name);
    std::string file = path_beside(procedure.file, stem + ".csv");
    for (int number = 2; !taken.insert(file).second; ++number) {
      file = path_beside(procedure.file, fmt::format("{}-{}.csv", stem, number));
    }
    reading.raw->file = file;
  }
}

std::string symmetric_point_text(const SymmetricPointProcedure& procedure, const std::string& name,
                                 const std::string& note) {
  SymmetricPointProcedure named = procedure;
  name_point_files(named);
  std::string text = "schema = \"armcal.symmetric/1\"\n";
  if (!name.empty()) text += fmt::format("name = {}\n", toml_quoted(name));
  if (!note.empty()) text += fmt::format("note = {}\n", toml_quoted(note));
  text += fmt::format("arm = {}\n", toml_quoted(path_to_write(named.file, named.arm_file)));
  if (named.u_encoder_rad > 0.0) {
    text += fmt::format("u_encoder_arcsec = {}\n",
                        decimal_text(arcseconds_from_radians(named.u_encoder_rad), 9));
  }
  for (const SymmetricReading& reading : named.readings) {
    text += reading_text(reading, named.file);
  }
  text += adjust_text(named);
  if (!named.unknown_signs.empty()) {
    text += fmt::format("\n[signs]\nunknown = {}\n", toml_list(named.unknown_signs));
  }
  return text + claims_text(named.claims);
}

std::string raw_points_csv(const SymmetricReading& reading) {
  const RawSymmetricPoints points = reading.raw.value_or(RawSymmetricPoints{});
  const std::size_t count = points.points_mm.size();
  const bool is_planned = count == 0;
  const bool has_angles = points.encoder_rad.cols() > 0 || is_planned;
  const bool has_ends =
      !points.end.empty() || (is_planned && reading.kind == SymmetricKind::reversal);
  const bool has_setting = !has_angles && !points.setting_rad.empty();
  ARMCAL_INVARIANT(!has_ends || points.end.size() == count);

  std::vector<std::string> rows;
  for (std::size_t i = 0; i < count; ++i) {
    std::string row = has_ends ? fmt::format("{},", points.end[i]) : "";
    row += point_fields(points.points_mm[i]);
    if (has_angles) {
      row += ',';
      row += angle_fields(points.encoder_rad.col(static_cast<Eigen::Index>(i)));
    }
    if (has_setting) {
      row += ',';
      row += angle_field(points.setting_rad[i]);
    }
    rows.push_back(std::move(row));
  }
  // A reader takes equal rows for a copy; a counter says that they are repeats.
  const bool has_counter = any_row_repeats(rows);
  std::string text = has_ends ? "end,x_mm,y_mm,z_mm" : "x_mm,y_mm,z_mm";
  const Eigen::Index joints = is_planned ? reading.posture_rad.size() : points.encoder_rad.rows();
  if (has_angles && joints > 0) {
    text += ',';
    text += angle_header(joints);
  }
  if (has_setting) text += fmt::format(",q{}_deg", reading.joint);
  text += has_counter ? ",repeat\n" : "\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += rows[i];
    if (has_counter) text += fmt::format(",{}", i + 1);
    text += '\n';
  }
  return text;
}

}  // namespace armcal
