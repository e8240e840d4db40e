// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/arm_file.h"

#include <fmt/format.h>

#include <cmath>

#include "armcal/core/units.h"
#include "armcal/io/number_text.h"
#include "armcal/io/plausibility.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

double degrees(TomlSection& section, std::string_view key) {
  return radians_from_degrees(section.number(key).value_or(0.0));
}

Link read_link(TomlSection section, Diagnostics& diagnostics) {
  Link link;
  link.d_mm = length_or_zero(section, "d_mm", diagnostics);
  link.b_mm = length_or_zero(section, "b_mm", diagnostics);
  link.a_mm = length_or_zero(section, "a_mm", diagnostics);
  link.alpha_rad = degrees(section, "alpha_deg");
  link.beta_rad = degrees(section, "beta_deg");
  section.finish();
  return link;
}

Joint read_joint(TomlSection section, Diagnostics& diagnostics) {
  Joint joint;
  joint.zero_rad = degrees(section, "zero_deg");
  joint.direction = section.integer("direction").value_or(1);
  if (joint.direction != 1 && joint.direction != -1) {
    diagnostics.error(section.where("direction"),
                      fmt::format("direction is {}: must be 1 or -1", joint.direction));
  }
  if (const auto lowest = section.number("min_deg")) joint.min_rad = radians_from_degrees(*lowest);
  if (const auto highest = section.number("max_deg"))
    joint.max_rad = radians_from_degrees(*highest);
  if (!(joint.min_rad < joint.max_rad)) {
    diagnostics.error(section.where("min_deg"), "min_deg is not below max_deg");
  }
  if (const auto harmonics = section.pairs("harmonics")) {
    for (const Eigen::Vector2d& pair : *harmonics) joint.harmonics.push_back({pair.x(), pair.y()});
    // Trailing zeros say nothing; one pair of zeros is how the files show the format.
    while (!joint.harmonics.empty() && joint.harmonics.back().cos_rad == 0.0 &&
           joint.harmonics.back().sin_rad == 0.0) {
      joint.harmonics.pop_back();
    }
  }
  section.finish();
  return joint;
}

std::optional<Eigen::Vector3d> read_triple(TomlSection& section, std::string_view key,
                                           Diagnostics& diagnostics) {
  const auto numbers = section.numbers(key);
  if (!numbers) return std::nullopt;
  if (numbers->size() != 3) {
    diagnostics.error(section.where(key),
                      fmt::format("{} has {} numbers: must have 3", key, numbers->size()));
    return std::nullopt;
  }
  return Eigen::Vector3d(*numbers);
}

Eigen::Vector3d radians_of(const Eigen::Vector3d& in_degrees) {
  return in_degrees.unaryExpr([](double angle) { return radians_from_degrees(angle); });
}

Tip read_tip(TomlSection section, Diagnostics& diagnostics) {
  Tip tip;
  tip.a_mm = length_or_zero(section, "a_mm", diagnostics);
  tip.b_mm = length_or_zero(section, "b_mm", diagnostics);
  tip.d_mm = length_or_zero(section, "d_mm", diagnostics);
  if (const auto angles = read_triple(section, "orientation_deg", diagnostics)) {
    tip.roll_pitch_yaw_rad = radians_of(*angles);
  }
  section.finish();
  return tip;
}

RigidTransform read_base(TomlSection section, Diagnostics& diagnostics) {
  RigidTransform base;
  if (const auto position = read_triple(section, "position_mm", diagnostics)) {
    base.translation_mm = *position;
    for (const double length : *position) {
      checked_length(length, "position_mm", section.where("position_mm"), diagnostics);
    }
  }
  if (const auto angles = read_triple(section, "orientation_deg", diagnostics)) {
    base.rotation = rotation_from_roll_pitch_yaw(radians_of(*angles));
  }
  section.finish();
  return base;
}

void read_links(TomlSection& root, ArmModel& arm, Diagnostics& diagnostics) {
  auto sections = root.sections("link");
  std::vector<double> twists_deg;
  for (TomlSection& section : sections) {
    arm.links.push_back(read_link(section, diagnostics));
    twists_deg.push_back(degrees_from_radians(arm.links.back().alpha_rad));
  }
  if (sections.empty()) return;
  warn_of_radians(twists_deg, "the values of alpha_deg", sections.front().where(), diagnostics);
}

void read_joints(TomlSection& root, ArmModel& arm, Diagnostics& diagnostics) {
  const auto sections = root.sections("joint");
  arm.joints.resize(arm.links.size() + 1);
  if (sections.empty()) return;
  if (sections.size() != arm.joints.size()) {
    diagnostics.error(
        sections.front().where(),
        fmt::format("{} [[joint]] tables for {} joints ({} [[link]] tables and the tip)",
                    sections.size(), arm.joints.size(), arm.links.size()),
        "write one [[joint]] for each joint, or none at all");
    return;
  }
  for (std::size_t i = 0; i < sections.size(); ++i) {
    arm.joints[i] = read_joint(sections[i], diagnostics);
  }
}

std::string triple_text(const Eigen::Vector3d& v, std::string (*text)(double)) {
  return fmt::format("[{}, {}, {}]", text(v.x()), text(v.y()), text(v.z()));
}

std::string link_text(const Link& link) {
  std::string text = fmt::format("\n[[link]]\nd_mm = {}\nb_mm = {}\na_mm = {}\nalpha_deg = {}\n",
                                 shortest_text(link.d_mm), shortest_text(link.b_mm),
                                 shortest_text(link.a_mm), degrees_text(link.alpha_rad));
  if (link.beta_rad != 0.0) text += fmt::format("beta_deg = {}\n", degrees_text(link.beta_rad));
  return text;
}

std::string joint_text(const Joint& joint) {
  std::string text = fmt::format("\n[[joint]]\nzero_deg = {}\n", degrees_text(joint.zero_rad));
  if (joint.direction != 1) text += fmt::format("direction = {}\n", joint.direction);
  if (std::isfinite(joint.min_rad))
    text += fmt::format("min_deg = {}\n", degrees_text(joint.min_rad));
  if (std::isfinite(joint.max_rad))
    text += fmt::format("max_deg = {}\n", degrees_text(joint.max_rad));
  if (!joint.harmonics.empty()) {
    text += "harmonics = [";
    for (std::size_t i = 0; i < joint.harmonics.size(); ++i) {
      text +=
          fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", shortest_text(joint.harmonics[i].cos_rad),
                      shortest_text(joint.harmonics[i].sin_rad));
    }
    text += "]\n";
  }
  return text;
}

bool is_plain(const Joint& joint) {
  return joint.zero_rad == 0.0 && joint.direction == 1 && !std::isfinite(joint.min_rad) &&
         !std::isfinite(joint.max_rad) && joint.harmonics.empty();
}

}  // namespace

std::optional<ArmModel> read_arm(const TextFile& file, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  TomlSection root(*document, diagnostics);
  check_schema(root, "arm", diagnostics);
  ArmModel arm;
  arm.name = root.text("name").value_or("");
  arm.note = root.text("note").value_or("");
  read_links(root, arm, diagnostics);
  read_joints(root, arm, diagnostics);
  if (auto section = root.section("tip")) arm.tip = read_tip(*section, diagnostics);
  if (auto section = root.section("base")) {
    arm.base_from_first_joint = read_base(*section, diagnostics);
  }
  root.finish();
  const int joints = arm.joint_count();
  if (joints < kMinJoints || joints > kMaxJoints) {
    diagnostics.error({file.path, 0, 0},
                      fmt::format("describes {} joint{}: an arm here has {} to {}", joints,
                                  joints == 1 ? "" : "s", kMinJoints, kMaxJoints),
                      "write one [[link]] for each step from joint to joint");
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return arm;
}

std::string arm_text(const ArmModel& arm) {
  std::string text = fmt::format("schema = \"armcal.arm/1\"\nname = {}\n", toml_quoted(arm.name));
  if (!arm.note.empty()) text += fmt::format("note = {}\n", toml_quoted(arm.note));
  const RigidTransform& base = arm.base_from_first_joint;
  if (!base.translation_mm.isZero(0.0) || !base.rotation.isIdentity(0.0)) {
    text += fmt::format("\n[base]\nposition_mm = {}\norientation_deg = {}\n",
                        triple_text(base.translation_mm, shortest_text),
                        triple_text(roll_pitch_yaw_from_rotation(base.rotation), degrees_text));
  }
  for (const Link& link : arm.links) text += link_text(link);
  text += fmt::format("\n[tip]\na_mm = {}\nb_mm = {}\nd_mm = {}\n", shortest_text(arm.tip.a_mm),
                      shortest_text(arm.tip.b_mm), shortest_text(arm.tip.d_mm));
  if (!arm.tip.roll_pitch_yaw_rad.isZero(0.0)) {
    text += fmt::format("orientation_deg = {}\n",
                        triple_text(arm.tip.roll_pitch_yaw_rad, degrees_text));
  }
  bool any_joint = false;
  for (const Joint& joint : arm.joints) any_joint = any_joint || !is_plain(joint);
  if (any_joint) {
    for (const Joint& joint : arm.joints) text += joint_text(joint);
  }
  return text;
}

}  // namespace armcal
