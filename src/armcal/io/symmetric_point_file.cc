// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/symmetric_point_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/spelling.h"
#include "armcal/core/units.h"
#include "armcal/io/plausibility.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

// Published results are rounded to the last digit printed, mostly 0.001 mm: half of that.
constexpr double kClaimUncertainty_mm = 0.0005;
constexpr double kClaimUncertainty_deg = 0.0005;

const std::vector<std::string> kReadingKinds = {"reversal", "circle_radius", "zero_search"};

std::optional<SymmetricKind> kind_of(TomlSection& section, Diagnostics& diagnostics) {
  const auto kind = section.required_text("kind");
  if (!kind) return std::nullopt;
  if (*kind == "reversal") return SymmetricKind::reversal;
  if (*kind == "circle_radius") return SymmetricKind::circle_radius;
  if (*kind == "zero_search") return SymmetricKind::zero_search;
  diagnostics.error(section.where("kind"), fmt::format("unknown kind \"{}\"", *kind),
                    did_you_mean(*kind, kReadingKinds));
  return std::nullopt;
}

// Value and uncertainty of a reading that was reduced by hand.
void read_reduced(TomlSection& section, SymmetricReading& reading,
                  std::optional<double> default_u_mm, Diagnostics& diagnostics) {
  const bool is_angle = reading.is_angle();
  const char* key = reading.kind == SymmetricKind::reversal        ? "distance_mm"
                    : reading.kind == SymmetricKind::circle_radius ? "radius_mm"
                                                                   : "angle_deg";
  const char* u_key = is_angle ? "u_deg" : "u_mm";
  const auto value = section.number(key);
  auto u = section.number(u_key);
  if (!value) {
    if (!section.has(key)) {
      diagnostics.error(section.where(),
                        fmt::format("reading \"{}\" has neither {} nor file", reading.name, key));
    }
    return;
  }
  if (!u && !is_angle) u = default_u_mm;
  if (!u) {
    diagnostics.error(
        section.where(), fmt::format("reading \"{}\" has no uncertainty", reading.name),
        fmt::format("give its {}{}", u_key, is_angle ? "" : ", or one u_mm for all at the top"));
    return;
  }
  if (!(*u > 0.0)) {
    diagnostics.error(section.where(u_key), fmt::format("{} must be larger than 0", u_key));
  }
  if (!is_angle && !(*value > 0.0)) {
    diagnostics.error(section.where(key), fmt::format("{} must be larger than 0", key));
  }
  reading.value = is_angle ? radians_from_degrees(*value) : *value;
  reading.u = is_angle ? radians_from_degrees(*u) : *u;
  reading.reduced = true;
}

// A half turn the other way, or one that is not quite a half turn.
void read_turn(TomlSection& section, SymmetricReading& reading, Diagnostics& diagnostics) {
  if (reading.kind != SymmetricKind::reversal) return;
  const double turn_deg = section.number("turn_deg").value_or(180.0);
  if (turn_deg == 0.0 || std::abs(turn_deg) > 360.0) {
    diagnostics.error(section.where("turn_deg"),
                      fmt::format("turn_deg is {}: must be within +-360 and not 0", turn_deg));
  }
  const bool has_joint = reading.joint >= 1 && reading.joint <= reading.posture_rad.size();
  if (has_joint) reading.posture_end_rad(reading.joint - 1) += radians_from_degrees(turn_deg);
}

SymmetricReading read_reading(TomlSection section, const std::string& path, std::size_t number,
                              std::optional<double> default_u_mm, Diagnostics& diagnostics) {
  SymmetricReading reading;
  reading.where = section.where();
  reading.name = section.text("name").value_or(fmt::format("reading {}", number));
  const auto kind = kind_of(section, diagnostics);
  if (kind) reading.kind = *kind;
  if (!section.has("joint")) diagnostics.error(section.where(), "joint is missing here");
  reading.joint = section.integer("joint").value_or(0);
  if (reading.kind == SymmetricKind::zero_search) {
    reading.sweep = section.integer("sweep").value_or(reading.joint - 1);
  }
  if (const auto posture = section.numbers("posture_deg")) {
    warn_of_radians({posture->data(), static_cast<std::size_t>(posture->size())},
                    "the angles of posture_deg", section.where("posture_deg"), diagnostics);
    reading.posture_rad =
        posture->unaryExpr([](double angle) { return radians_from_degrees(angle); });
    reading.posture_end_rad = reading.posture_rad;
  }
  read_turn(section, reading, diagnostics);
  const auto file = section.text("file");
  if (kind && file) {
    reading.raw = RawSymmetricPoints{};
    reading.raw->file = path_beside(path, *file);
    reading.u = section.number("u_mm").value_or(0.0);
    if (reading.u < 0.0) diagnostics.error(section.where("u_mm"), "u_mm must not be negative");
  } else if (kind) {
    read_reduced(section, reading, default_u_mm, diagnostics);
  }
  reading.solves = section.text("solves").value_or("");
  if (section.boolean("check").value_or(false) && !reading.solves.empty()) {
    diagnostics.error(section.where("check"),
                      fmt::format("reading \"{}\" cannot both solve {} and be a check",
                                  reading.name, reading.solves));
  }
  section.finish();
  return reading;
}

std::vector<Claim> read_claims(TomlSection section, Diagnostics& diagnostics) {
  std::vector<Claim> claims;
  const double u_mm = section.number("u_mm").value_or(kClaimUncertainty_mm);
  const double u_deg = section.number("u_deg").value_or(kClaimUncertainty_deg);
  for (const auto& [key, value] : section.all_numbers()) {
    if (key == "u_mm" || key == "u_deg") continue;
    const bool in_mm = key.ends_with("_mm");
    const bool in_deg = key.ends_with("_deg");
    if (!in_mm && !in_deg) {
      diagnostics.error(section.where(key), fmt::format("claim \"{}\" has no unit", key),
                        fmt::format("write {}_mm or {}_deg", key, key));
      continue;
    }
    Claim claim;
    claim.parameter = key.substr(0, key.rfind('_'));
    claim.value = in_mm ? value : radians_from_degrees(value);
    claim.u = in_mm ? u_mm : radians_from_degrees(u_deg);
    claim.where = section.where(key);
    claims.push_back(claim);
  }
  section.finish();
  return claims;
}

void check_names_are_unique(const SymmetricPointProcedure& procedure, Diagnostics& diagnostics) {
  std::set<std::string> names;
  std::set<std::string> solved;
  for (const SymmetricReading& reading : procedure.readings) {
    if (!names.insert(reading.name).second) {
      diagnostics.error(reading.where, fmt::format("two readings are named \"{}\"", reading.name));
    }
    if (!reading.solves.empty() && !solved.insert(reading.solves).second) {
      diagnostics.error(reading.where, fmt::format("two readings solve {}", reading.solves),
                        "let one of them be a check: check = true");
    }
  }
}

// --- against the arm
// ------------------------------------------------------------------------------

void check_posture(SymmetricReading& reading, const ArmModel& arm, Diagnostics& diagnostics) {
  const int n = arm.joint_count();
  if (reading.posture_rad.size() == 0) {
    const bool needs_none = reading.kind == SymmetricKind::circle_radius && reading.joint == n;
    if (!needs_none) {
      diagnostics.error(reading.where,
                        fmt::format("reading \"{}\" has no posture_deg", reading.name),
                        fmt::format("give {} angles, one per joint", n));
      return;
    }
    reading.posture_rad = Eigen::VectorXd::Zero(n);
    reading.posture_end_rad = reading.posture_rad;
  } else if (reading.posture_rad.size() != n) {
    diagnostics.error(
        reading.where,
        fmt::format("reading \"{}\": posture_deg has {} angles, the arm has {} joints",
                    reading.name, reading.posture_rad.size(), n));
    return;
  }
}

void check_reading(SymmetricReading& reading, const ArmModel& arm, const ParameterTable& table,
                   Diagnostics& diagnostics) {
  const int n = arm.joint_count();
  if (reading.joint < 1 || reading.joint > n) {
    diagnostics.error(reading.where,
                      fmt::format("reading \"{}\": joint {} of an arm with {} joints", reading.name,
                                  reading.joint, n));
    return;
  }
  if (reading.kind == SymmetricKind::zero_search &&
      (reading.sweep < 1 || reading.sweep >= reading.joint)) {
    diagnostics.error(reading.where,
                      fmt::format("zero search \"{}\": sweep = {} is not a joint below joint {}",
                                  reading.name, reading.sweep, reading.joint),
                      "turning a joint moves nothing relative to the axes after it");
    return;
  }
  check_posture(reading, arm, diagnostics);
  if (!reading.solves.empty() && !table.find(reading.solves)) {
    diagnostics.error(reading.where,
                      fmt::format("solves = \"{}\": no such parameter", reading.solves),
                      did_you_mean(reading.solves, table.names()));
  }
}

void check_patterns(const std::vector<std::string>& patterns, const std::string& file,
                    const ParameterTable& table, Diagnostics& diagnostics) {
  for (const std::string& pattern : patterns) {
    if (table.matching(pattern).empty()) {
      diagnostics.error({file, 0, 0}, fmt::format("no parameter is named \"{}\"", pattern),
                        did_you_mean(pattern, table.names()));
    }
  }
}

}  // namespace

std::optional<SymmetricPointProcedure> read_symmetric_point_file(const TextFile& file,
                                                                 Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  TomlSection root(*document, diagnostics);
  check_schema(root, "symmetric", diagnostics);
  SymmetricPointProcedure procedure;
  procedure.file = file.path;
  static_cast<void>(root.text("name"));
  static_cast<void>(root.text("note"));
  if (const auto arm = root.required_text("arm")) procedure.arm_file = path_beside(file.path, *arm);
  const auto u_mm = root.number("u_mm");
  if (u_mm && !(*u_mm > 0.0)) diagnostics.error(root.where("u_mm"), "u_mm must be larger than 0");
  if (const auto u = root.number("u_encoder_arcsec")) {
    if (*u < 0.0) {
      diagnostics.error(root.where("u_encoder_arcsec"), "u_encoder_arcsec must not be negative");
    }
    procedure.u_encoder_rad = radians_from_arcseconds(*u);
  }
  for (TomlSection& section : root.sections("reading")) {
    procedure.readings.push_back(
        read_reading(section, file.path, procedure.readings.size() + 1, u_mm, diagnostics));
  }
  if (procedure.readings.empty()) {
    diagnostics.error({file.path, 0, 0}, "has no readings", "write one [[reading]] for each");
  }
  if (auto section = root.section("adjust")) {
    procedure.unknowns = section->texts("unknowns").value_or(std::vector<std::string>{});
    procedure.hold = section->texts("hold").value_or(std::vector<std::string>{});
    procedure.significance = section->number("significance").value_or(procedure.significance);
    procedure.power = section->number("power").value_or(procedure.power);
    for (const auto& [key, value] :
         {std::pair{"significance", procedure.significance}, {"power", procedure.power}}) {
      if (!(value > 0.0 && value < 1.0)) {
        diagnostics.error(section->where(key), fmt::format("{} must lie between 0 and 1", key));
      }
    }
    section->finish();
  }
  if (auto section = root.section("signs")) {
    procedure.unknown_signs = section->texts("unknown").value_or(std::vector<std::string>{});
    section->finish();
  }
  if (auto section = root.section("claims")) procedure.claims = read_claims(*section, diagnostics);
  root.finish();
  check_names_are_unique(procedure, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return procedure;
}

bool check_against_arm(SymmetricPointProcedure& procedure, const ArmModel& arm,
                       Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const ParameterTable table(arm);
  for (SymmetricReading& reading : procedure.readings) {
    check_reading(reading, arm, table, diagnostics);
  }
  for (const Claim& claim : procedure.claims) {
    const auto index = table.find(claim.parameter);
    if (!index) {
      diagnostics.error(claim.where,
                        fmt::format("claim of \"{}\": no such parameter", claim.parameter),
                        did_you_mean(claim.parameter, table.names()));
    }
  }
  check_patterns(procedure.unknowns, procedure.file, table, diagnostics);
  check_patterns(procedure.hold, procedure.file, table, diagnostics);
  for (const std::string& name : procedure.unknown_signs) {
    std::vector<std::string> known = table.names();
    for (int joint = 1; joint <= arm.joint_count(); ++joint) {
      known.push_back(fmt::format("direction{}", joint));
    }
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      diagnostics.error({procedure.file, 0, 0},
                        fmt::format("unknown sign of \"{}\": no such parameter", name),
                        did_you_mean(name, known));
    }
  }
  return diagnostics.error_count() == errors_before;
}

}  // namespace armcal
