// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/urdf_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "armcal/arm/joint_chain.h"
#include "armcal/io/number_text.h"
#include "armcal/io/xml_text.h"

namespace armcal {
namespace {

// Rounding of rotation matrices where 0 is meant: at a reach of 10 m below 1e-11 mm.
constexpr double kRounding_rad = 1e-15;

std::string radians_text(double rad) {
  return std::abs(rad) < kRounding_rad ? "0.0" : shortest_text(rad);
}

std::string metres_text(double mm) {
  return mm == 0.0 ? "0.0" : shortest_text(with_point_moved(mm, -3));  // 0 of either sign
}

/// Text of a comment, in which two hyphens may not stand side by side.
std::string xml_comment(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '-' && result.ends_with('-')) result += ' ';
    const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
    result += is_control ? ' ' : c;
  }
  return result;
}

std::string joint_element(std::string_view name, std::string_view type, std::string_view parent,
                          std::string_view child, const RigidTransform& parent_from_joint) {
  const Eigen::Vector3d& p = parent_from_joint.translation_mm;
  const Eigen::Vector3d angles = roll_pitch_yaw_from_rotation(parent_from_joint.rotation);
  return fmt::format(
      "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n"
      "    <origin xyz=\"{} {} {}\" rpy=\"{} {} {}\"/>\n",
      name, type, parent, child, metres_text(p.x()), metres_text(p.y()), metres_text(p.z()),
      radians_text(angles.x()), radians_text(angles.y()), radians_text(angles.z()));
}

}  // namespace

UrdfText urdf_text(const ArmModel& arm) {
  const ChainConversion conversion = chain_from_arm(arm);
  const JointChain& chain = conversion.chain;
  UrdfText result{"<?xml version=\"1.0\"?>\n", conversion.lost};
  std::string& text = result.text;
  if (!arm.note.empty()) text += fmt::format("<!-- {} -->\n", xml_comment(arm.note));
  text += fmt::format("<robot name=\"{}\">\n", xml_escaped(arm.name.empty() ? "arm" : arm.name));
  const std::size_t n = chain.joints.size();
  for (std::size_t i = 0; i <= n; ++i) text += fmt::format("  <link name=\"link_{}\"/>\n", i);
  text += "  <link name=\"tip\"/>\n";
  for (std::size_t i = 0; i < n; ++i) {
    const ChainJoint& joint = chain.joints[i];
    const bool has_lower = std::isfinite(joint.min_rad);
    const bool has_upper = std::isfinite(joint.max_rad);
    const bool stops = has_lower && has_upper;
    if (has_lower != has_upper) {
      result.lost.push_back(fmt::format("limit on one side only of joint {}", i + 1));
    }
    text += joint_element(fmt::format("joint_{}", i + 1), stops ? "revolute" : "continuous",
                          fmt::format("link_{}", i), fmt::format("link_{}", i + 1),
                          joint.parent_from_joint);
    text += fmt::format("    <axis xyz=\"0 0 {:.0f}\"/>\n", joint.axis_in_joint.z());
    // Effort and velocity must be there; an arm that is moved by hand has neither.
    if (stops) {
      text += fmt::format("    <limit lower=\"{}\" upper=\"{}\" effort=\"0\" velocity=\"0\"/>\n",
                          shortest_text(joint.min_rad), shortest_text(joint.max_rad));
    }
    text += "  </joint>\n";
  }
  text +=
      joint_element("joint_tip", "fixed", fmt::format("link_{}", n), "tip", chain.last_from_tip);
  text += "  </joint>\n</robot>\n";
  return result;
}

}  // namespace armcal
