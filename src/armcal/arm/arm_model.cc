// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/arm_model.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace armcal {
namespace {

bool is_finite(const Link& link) {
  return std::isfinite(link.d_mm) && std::isfinite(link.b_mm) && std::isfinite(link.a_mm) &&
         std::isfinite(link.alpha_rad) && std::isfinite(link.beta_rad);
}

void check_joint(const Joint& joint, std::size_t number, std::vector<std::string>& problems) {
  if (!std::isfinite(joint.zero_rad)) {
    problems.push_back(fmt::format("joint {}: zero offset is not finite", number));
  }
  if (joint.direction != 1 && joint.direction != -1) {
    problems.push_back(
        fmt::format("joint {}: direction {} is neither 1 nor -1", number, joint.direction));
  }
  if (!(joint.min_rad < joint.max_rad)) {
    problems.push_back(fmt::format("joint {}: lower limit is not below the upper limit", number));
  }
  for (const Harmonic& harmonic : joint.harmonics) {
    if (!std::isfinite(harmonic.cos_rad) || !std::isfinite(harmonic.sin_rad)) {
      problems.push_back(fmt::format("joint {}: a harmonic is not finite", number));
    }
  }
}

}  // namespace

bool is_nearly_parallel(const Link& link) {
  return std::abs(std::sin(link.alpha_rad)) < std::sin(kNearlyParallel_rad);
}

// As matrices: through quaternions 90 deg would lose its last digit.
Eigen::Matrix3d twist(const Link& link) {
  return Eigen::AngleAxisd(link.alpha_rad, Eigen::Vector3d::UnitX()).toRotationMatrix() *
         Eigen::AngleAxisd(link.beta_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

std::vector<std::string> problems_of(const ArmModel& arm) {
  std::vector<std::string> problems;
  const std::size_t n = arm.joints.size();
  if (n < kMinJoints || n > kMaxJoints) {
    problems.push_back(
        fmt::format("{} joints: an arm here has {} to {}", n, kMinJoints, kMaxJoints));
  }
  if (arm.links.size() + 1 != n) {
    problems.push_back(fmt::format("{} links for {} joints: expected one link fewer than joints",
                                   arm.links.size(), n));
  }
  for (std::size_t i = 0; i < n; ++i) check_joint(arm.joints[i], i + 1, problems);
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    if (!is_finite(arm.links[i])) {
      problems.push_back(fmt::format("link into joint {}: a number is not finite", i + 2));
    }
  }
  if (!std::isfinite(arm.tip.a_mm) || !std::isfinite(arm.tip.b_mm) ||
      !std::isfinite(arm.tip.d_mm) || !arm.tip.roll_pitch_yaw_rad.allFinite()) {
    problems.emplace_back("tip: a number is not finite");
  }
  if (!arm.base_from_first_joint.rotation.allFinite() ||
      !arm.base_from_first_joint.translation_mm.allFinite()) {
    problems.emplace_back("base: a number is not finite");
  }
  return problems;
}

double reach_mm(const ArmModel& arm) {
  double reach = std::hypot(arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm);
  for (const Link& link : arm.links) reach += std::hypot(link.a_mm, link.b_mm, link.d_mm);
  return reach;
}

ArmModel with_harmonics(ArmModel arm, int harmonics) {
  for (Joint& joint : arm.joints) {
    joint.harmonics.resize(std::max(joint.harmonics.size(), static_cast<std::size_t>(harmonics)));
  }
  return arm;
}

}  // namespace armcal
