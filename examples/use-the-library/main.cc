// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// Where is the tip of a two-joint arm, and which circle does it draw?
#include <cstdio>
#include <vector>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/geometry/circle.h"

int main() {
  armcal::ArmModel arm;
  arm.joints.resize(2);
  arm.links = {{.a_mm = 300.0}};
  arm.tip.a_mm = 200.0;

  const armcal::ForwardKinematics kinematics(arm);
  std::vector<Eigen::Vector3d> tips;
  for (const double q2 : {0.0, 0.5, 1.0, 1.5}) {
    tips.push_back(kinematics.tip_in_base(std::vector{0.3, q2}));
  }
  const armcal::CircleFit circle = armcal::fit_circle(tips);
  std::printf("radius %.6f mm about joint 2\n", circle.radius_mm);
  return circle.ok() ? 0 : 1;
}
