// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/session_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "armcal/io/number_text.h"
#include "armcal/io/text_file.h"
#include "armcal/io/toml_text.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

std::string entry(const char* key, double value) {
  return fmt::format("{} = {}\n", key, shortest_text(value));
}
std::string entry(const char* key, const std::optional<double>& value) {
  return value ? entry(key, *value) : "";
}
std::string entry(const char* key, const std::string& text) {
  return text.empty() ? "" : fmt::format("{} = {}\n", key, toml_quoted(text));
}

std::string kind_text(const SessionGroup& group) {
  std::string text;
  switch (group.kind) {
    case ReferenceKind::length:
      return entry("to", group.place_to) + entry("length_mm", group.length_mm);
    case ReferenceKind::reversal:
      if (group.joint) text += fmt::format("joint = {}\n", *group.joint);
      return text + fmt::format("turn_deg = {}\n", degrees_text(group.turn_rad));
    case ReferenceKind::circle_radius:
      if (group.joint) text += fmt::format("joint = {}\n", *group.joint);
      return text;
    case ReferenceKind::sphere:
      text += entry("radius_mm", group.radius_mm);
      if (group.tip_radius_mm == 0.0) return text;
      text += entry("tip_diameter_mm", 2.0 * std::abs(group.tip_radius_mm));
      return text + (group.tip_radius_mm < 0.0 ? "inside = true\n" : "");
    case ReferenceKind::reference_poses:
      return group.lever_mm == SessionGroup{}.lever_mm ? "" : entry("lever_mm", group.lever_mm);
    default:
      return text;
  }
}

std::string u_encoder_text(double u_rad) {
  return u_rad > 0.0 ? fmt::format("u_encoder_arcsec = {}\n", arcseconds_text(u_rad)) : "";
}

bool all_encoders_alike(const std::vector<SessionGroup>& groups) {
  return std::all_of(groups.begin(), groups.end(), [&](const SessionGroup& group) {
    return group.u_encoder_rad == groups.front().u_encoder_rad;
  });
}

std::string group_text(const SessionGroup& group, const std::string& session_file,
                       bool with_encoders) {
  const bool is_called_like_its_file =
      !group.file.empty() && std::filesystem::path(group.file).stem() == group.name;
  std::string text = fmt::format("\n[[observations]]\nkind = \"{}\"\n", to_string(group.kind));
  if (!is_called_like_its_file) text += entry("name", group.name);
  if (!group.file.empty()) text += entry("file", path_to_write(session_file, group.file));
  if (!group.artefact_file.empty()) {
    text += entry("artefact", path_to_write(session_file, group.artefact_file));
  }
  if (const char* key = place_key(group.kind)) text += entry(key, group.place);
  text += kind_text(group) + entry("u_mm", group.u_mm) + entry("set", group.set);
  if (with_encoders) text += u_encoder_text(group.u_encoder_rad);
  if (!group.offset_mm.isZero(0.0)) {
    text += fmt::format("offset_mm = [{}, {}, {}]\n", shortest_text(group.offset_mm.x()),
                        shortest_text(group.offset_mm.y()), shortest_text(group.offset_mm.z()));
  }
  text += entry("target", group.target);
  if (group.table.keep_duplicates) text += "keep_duplicates = true\n";
  if (group.table.keep_zero_points) text += "keep_zero_points = true\n";
  return text;
}

std::string prior_text(const SessionEstimate& estimate) {
  std::vector<std::string> priors;
  const auto add = [&](const char* key, const std::optional<double>& value, bool is_angle) {
    if (!value) return;
    priors.push_back(
        fmt::format("{} = {}", key, is_angle ? degrees_text(*value) : shortest_text(*value)));
  };
  add("length_mm", estimate.prior_length_mm, false);
  if (estimate.prior_zero_rad == estimate.prior_twist_rad) {
    add("angle_deg", estimate.prior_zero_rad, true);
  } else {
    add("zero_deg", estimate.prior_zero_rad, true);
    add("twist_deg", estimate.prior_twist_rad, true);
  }
  add("harmonic_rad", estimate.prior_harmonic_rad, false);
  for (const auto& [name, u] : estimate.prior_of) priors.push_back(toml_parameter(name, u));
  return priors.empty() ? "" : fmt::format("prior = {{ {} }}\n", fmt::join(priors, ", "));
}

std::string estimate_text(const SessionEstimate& estimate) {
  const SessionEstimate usual;
  std::string text;
  if (!estimate.hold.empty()) text += fmt::format("hold = {}\n", toml_list(estimate.hold));
  text += prior_text(estimate);
  if (estimate.harmonics != usual.harmonics) {
    text += fmt::format("harmonics = {}\n", estimate.harmonics);
  }
  if (estimate.loss != usual.loss) text += entry("loss", estimate.loss);
  if (estimate.check_fraction != usual.check_fraction) {
    text += entry("check_fraction", estimate.check_fraction);
  }
  if (estimate.check_seed != usual.check_seed) {
    text += fmt::format("check_seed = {}\n", estimate.check_seed);
  }
  return text.empty() ? "" : "\n[estimate]\n" + text;
}

}  // namespace

std::string session_text(const Session& session, const std::string& note) {
  std::string text = "schema = \"armcal.session/1\"\n";
  text += entry("name", session.name) + entry("note", note) +
          entry("arm", path_to_write(session.file, session.arm_file));
  const bool alike = all_encoders_alike(session.groups);
  if (alike && !session.groups.empty()) {
    text += u_encoder_text(session.groups.front().u_encoder_rad);
  }
  for (const SessionGroup& group : session.groups) {
    text += group_text(group, session.file, !alike);
  }
  return text + estimate_text(session.estimate);
}

}  // namespace armcal
