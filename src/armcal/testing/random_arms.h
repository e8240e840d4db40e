// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/testing/random_geometry.h"

namespace armcal::testing {

struct RandomArmOptions {
  bool arbitrary_twists =
      true;  ///< any twist; else +-90 deg with errors of a few hundredths of a degree
  bool beta = true;
  int harmonics = 2;
  bool mount = true;  ///< base frame away from the first joint, flange turned
};

/// An arm with every parameter different from zero.
inline ArmModel random_arm(int joint_count, RandomStream& random,
                           const RandomArmOptions& options = {}) {
  using std::numbers::pi;
  ArmModel arm;
  arm.name = "random arm";
  for (int i = 0; i < joint_count; ++i) {
    Joint joint;
    joint.zero_rad = random.uniform(-0.5, 0.5);
    joint.direction = random.below(2) == 0 ? 1 : -1;
    for (int k = 0; k < options.harmonics; ++k) {
      joint.harmonics.push_back({1e-3 * random.normal(), 1e-3 * random.normal()});
    }
    arm.joints.push_back(joint);
  }
  for (int i = 0; i + 1 < joint_count; ++i) {
    Link link;
    link.d_mm = 100.0 * random.normal();
    link.b_mm = random.uniform(100.0, 800.0);
    link.a_mm = 50.0 * random.normal();
    link.alpha_rad = options.arbitrary_twists
                         ? random.uniform(-pi, pi)
                         : (i % 2 == 0 ? 0.5 : -0.5) * pi + 5e-4 * random.normal();
    link.beta_rad = options.beta ? 0.1 * random.normal() : 0.0;
    arm.links.push_back(link);
  }
  arm.tip.a_mm = 50.0 * random.normal();
  arm.tip.b_mm = random.uniform(50.0, 300.0);
  arm.tip.d_mm = 50.0 * random.normal();
  if (options.mount) {
    arm.base_from_first_joint = random_transform(random, 300.0);
    arm.tip.roll_pitch_yaw_rad = 0.5 * random_normal_vector(random);
  }
  return arm;
}

inline std::vector<double> random_posture(int joint_count, RandomStream& random,
                                          double range_rad = std::numbers::pi) {
  std::vector<double> posture;
  for (int i = 0; i < joint_count; ++i) posture.push_back(random.uniform(-range_rad, range_rad));
  return posture;
}

/// Postures as columns.
inline Eigen::MatrixXd random_postures(int joint_count, int count, RandomStream& random,
                                       double range_rad = std::numbers::pi) {
  Eigen::MatrixXd postures(joint_count, count);
  for (double& angle : postures.reshaped()) angle = random.uniform(-range_rad, range_rad);
  return postures;
}

}  // namespace armcal::testing
