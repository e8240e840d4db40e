// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/session_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "armcal/core/spelling.h"
#include "armcal/core/units.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

void check_positive(TomlSection& section, const char* key, const std::optional<double>& value,
                    Diagnostics& diagnostics) {
  if (value && !(*value > 0.0)) {
    diagnostics.error(section.where(key),
                      fmt::format("{} is {}: must be larger than 0", key, *value));
  }
}

// Standard uncertainty of an encoder reading; 0 says that encoders are exact.
std::optional<double> u_encoder_of(TomlSection& section, Diagnostics& diagnostics) {
  const auto arcsec = section.number("u_encoder_arcsec");
  if (!arcsec) return std::nullopt;
  if (!(*arcsec >= 0.0)) {
    diagnostics.error(section.where("u_encoder_arcsec"),
                      fmt::format("u_encoder_arcsec is {}: must not be negative", *arcsec));
  }
  return radians_from_arcseconds(*arcsec);
}

void read_kind_keys(TomlSection& section, SessionGroup& group, Diagnostics& diagnostics) {
  switch (group.kind) {
    case ReferenceKind::artefact:
      if (const auto artefact = section.required_text("artefact")) {
        group.artefact_file = path_beside(group.where.file, *artefact);
      }
      break;
    case ReferenceKind::length:
      group.place_to = section.text("to").value_or("");
      group.length_mm = section.number("length_mm");
      check_positive(section, "length_mm", group.length_mm, diagnostics);
      break;
    case ReferenceKind::reversal:
      group.joint = section.integer("joint");
      group.turn_rad = radians_from_degrees(section.number("turn_deg").value_or(180.0));
      break;
    case ReferenceKind::circle_radius:
      group.joint = section.integer("joint");
      break;
    case ReferenceKind::sphere: {
      group.radius_mm = section.number("radius_mm");
      check_positive(section, "radius_mm", group.radius_mm, diagnostics);
      if (const auto diameter = section.number("diameter_mm")) {
        check_positive(section, "diameter_mm", diameter, diagnostics);
        group.radius_mm = *diameter / 2.0;
      }
      const double tip = section.number("tip_diameter_mm").value_or(0.0) / 2.0;
      group.tip_radius_mm = section.boolean("inside").value_or(false) ? -tip : tip;
      break;
    }
    case ReferenceKind::reference_poses: {
      const auto lever = section.number("lever_mm");
      check_positive(section, "lever_mm", lever, diagnostics);
      group.lever_mm = lever.value_or(group.lever_mm);
      break;
    }
    default:
      break;
  }
}

// What the top of a session says for all of its groups.
struct SessionDefaults {
  std::optional<AngleUnit> angles;
  double u_encoder_rad = 0.0;
};

SessionGroup read_group(TomlSection section, const std::string& path,
                        const SessionDefaults& defaults, Diagnostics& diagnostics) {
  SessionGroup group;
  group.where = section.where();
  const auto kind = section.required_text("kind");
  if (kind) {
    const auto known = reference_kind_named(*kind);
    if (!known) {
      diagnostics.error(section.where("kind"), fmt::format("unknown kind \"{}\"", *kind),
                        did_you_mean(*kind, reference_kind_names()));
    }
    group.kind = known.value_or(group.kind);
  }
  if (const auto file = section.text("file")) group.file = path_beside(path, *file);
  const bool in_place = group.kind == ReferenceKind::length && section.has("length_mm");
  if (group.file.empty() && !in_place) {
    diagnostics.error(section.where(), "file is missing here",
                      "name the table of readings: file = \"readings.csv\"");
  }
  group.name = section.text("name").value_or("");
  group.u_mm = section.number("u_mm");
  check_positive(section, "u_mm", group.u_mm, diagnostics);
  group.u_encoder_rad = u_encoder_of(section, diagnostics).value_or(defaults.u_encoder_rad);
  group.set = section.text("set").value_or("");
  if (!group.set.empty() && group.set != "fit" && group.set != "check") {
    diagnostics.error(section.where("set"),
                      fmt::format("set is \"{}\": must be fit or check", group.set));
  }
  if (const char* key = place_key(group.kind)) group.place = section.text(key).value_or("");
  if (const auto offset = section.numbers("offset_mm")) {
    if (offset->size() == 3) {
      group.offset_mm = *offset;
    } else {
      diagnostics.error(section.where("offset_mm"), "offset_mm must have 3 numbers");
    }
  }
  group.target = section.text("target").value_or("");
  group.table.angles = angle_unit_of(section, diagnostics);
  if (!group.table.angles) group.table.angles = defaults.angles;
  group.table.keep_duplicates = section.boolean("keep_duplicates").value_or(false);
  group.table.keep_zero_points = section.boolean("keep_zero_points").value_or(false);
  if (auto map = section.section("map")) {
    for (auto& [ours, theirs] : map->all_texts()) group.table.map[ours] = theirs;
    map->finish();
  }
  read_kind_keys(section, group, diagnostics);
  section.finish();
  return group;
}

void read_prior(TomlSection section, SessionEstimate& estimate, Diagnostics& diagnostics) {
  for (const auto& [key, value] : section.all_numbers()) {
    if (!(value > 0.0)) {
      diagnostics.error(section.where(key),
                        fmt::format("{} is {}: must be larger than 0", key, value));
      continue;
    }
    const double radians = radians_from_degrees(value);
    if (key == "length_mm") {
      estimate.prior_length_mm = value;
    } else if (key == "zero_deg") {
      estimate.prior_zero_rad = radians;
    } else if (key == "twist_deg") {
      estimate.prior_twist_rad = radians;
    } else if (key == "angle_deg") {
      estimate.prior_zero_rad = estimate.prior_twist_rad = radians;
    } else if (key == "harmonic_rad") {
      estimate.prior_harmonic_rad = value;
    } else if (key.ends_with("_mm")) {
      estimate.prior_of[key.substr(0, key.size() - 3)] = value;
    } else if (key.ends_with("_deg")) {
      estimate.prior_of[key.substr(0, key.size() - 4)] = radians;
    } else {
      diagnostics.error(section.where(key), fmt::format("unknown prior \"{}\"", key),
                        "known: length_mm, angle_deg, zero_deg, twist_deg, harmonic_rad, and "
                        "parameters as a5_mm or "
                        "zero3_deg");
    }
  }
}

// Groups are told apart by their names: the file's where none is given, with a number where that is
// taken.
void name_groups(std::vector<SessionGroup>& groups) {
  std::map<std::string, int> count;
  for (SessionGroup& group : groups) {
    if (group.name.empty()) {
      group.name = group.file.empty() ? fmt::format("{} {} to {}", to_string(group.kind),
                                                    group.place, group.place_to)
                                      : std::filesystem::path(group.file).stem().string();
    }
    const int number = ++count[group.name];
    if (number > 1) group.name += fmt::format(" ({})", number);
  }
}

}  // namespace

std::optional<AngleUnit> angle_unit_of(TomlSection& section, Diagnostics& diagnostics) {
  const auto text = section.text("angles");
  if (!text) return std::nullopt;
  if (*text == "deg") return AngleUnit::deg;
  if (*text == "rad") return AngleUnit::rad;
  diagnostics.error(section.where("angles"),
                    fmt::format("angles is \"{}\": must be deg or rad", *text));
  return std::nullopt;
}

const char* place_key(ReferenceKind kind) {
  switch (kind) {
    case ReferenceKind::reference_points:
    case ReferenceKind::reference_poses:
      return "setup";
    case ReferenceKind::artefact:
      return "placement";
    case ReferenceKind::fixed_point:
      return "point";
    case ReferenceKind::sphere:
      return "sphere";
    case ReferenceKind::plane:
      return "plane";
    case ReferenceKind::length:
      return "from";
    case ReferenceKind::reversal:
    case ReferenceKind::circle_radius:
      return nullptr;
  }
  return nullptr;
}

SessionEstimate read_session_estimate(TomlSection& section, Diagnostics& diagnostics) {
  SessionEstimate estimate;
  estimate.hold = section.texts("hold").value_or(std::vector<std::string>{});
  estimate.harmonics = section.integer("harmonics").value_or(0);
  constexpr int kMostHarmonics = 10;
  if (estimate.harmonics < 0 || estimate.harmonics > kMostHarmonics) {
    diagnostics.error(section.where("harmonics"), fmt::format("harmonics is {}: must be 0 to {}",
                                                              estimate.harmonics, kMostHarmonics));
  }
  estimate.loss = section.text("loss").value_or("none");
  if (estimate.loss != "none" && estimate.loss != "huber" && estimate.loss != "cauchy") {
    diagnostics.error(section.where("loss"),
                      fmt::format("loss is \"{}\": must be none, huber or cauchy", estimate.loss));
  }
  estimate.check_fraction = section.number("check_fraction").value_or(0.0);
  if (!(estimate.check_fraction >= 0.0 && estimate.check_fraction < 1.0)) {
    diagnostics.error(section.where("check_fraction"),
                      "check_fraction must be at least 0 and below 1");
  }
  estimate.check_seed = static_cast<std::uint64_t>(section.integer("check_seed").value_or(1));
  if (auto prior = section.section("prior")) read_prior(*prior, estimate, diagnostics);
  section.finish();
  return estimate;
}

std::optional<Session> read_session_file(const TextFile& file, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  TomlSection root(*document, diagnostics);
  check_schema(root, "session", diagnostics);
  Session session;
  session.file = file.path;
  session.name = root.text("name").value_or("");
  static_cast<void>(root.text("note"));
  if (const auto arm = root.required_text("arm")) session.arm_file = path_beside(file.path, *arm);
  const SessionDefaults defaults{angle_unit_of(root, diagnostics),
                                 u_encoder_of(root, diagnostics).value_or(0.0)};
  for (TomlSection& section : root.sections("observations")) {
    session.groups.push_back(read_group(section, file.path, defaults, diagnostics));
  }
  if (session.groups.empty()) {
    diagnostics.error({file.path, 0, 0}, "has no observations",
                      "write one [[observations]] for each file of readings");
  }
  name_groups(session.groups);
  if (auto section = root.section("estimate")) {
    session.estimate = read_session_estimate(*section, diagnostics);
  }
  root.finish();
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return session;
}

}  // namespace armcal
