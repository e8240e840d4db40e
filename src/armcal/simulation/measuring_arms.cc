// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/measuring_arms.h"

#include <numbers>

#include "armcal/core/units.h"

namespace armcal {
namespace {

// Axes at right angles in turn, as on every such arm.
ArmModel right_angled_arm(const std::string& name, int joints) {
  ArmModel arm;
  arm.name = name;
  arm.joints.resize(static_cast<std::size_t>(joints));
  arm.links.resize(static_cast<std::size_t>(joints) - 1);
  for (std::size_t i = 0; i < arm.links.size(); ++i) {
    arm.links[i].alpha_rad = (i % 2 == 0 ? 0.5 : -0.5) * std::numbers::pi;
  }
  return arm;
}

}  // namespace

ArmModel romer_arm() {
  ArmModel arm = right_angled_arm("ROMER Infinite 2.0, nominal", 6);
  arm.links[1].b_mm = 750.0;
  arm.links[3].b_mm = 530.0;
  arm.links[3].a_mm = 80.0;
  arm.tip.a_mm = -25.0;
  arm.tip.b_mm = 175.0;
  return arm;
}

ArmModel seven_joint_arm() {
  ArmModel arm = right_angled_arm("seven-joint measuring arm", 7);
  arm.links[0].d_mm = 300.0;
  arm.links[1].b_mm = 600.0;
  arm.links[2].a_mm = 45.0;
  arm.links[3].b_mm = 500.0;
  arm.links[4].a_mm = 35.0;
  arm.links[5].b_mm = 100.0;
  arm.tip.a_mm = 30.0;
  arm.tip.d_mm = 150.0;
  const double range_deg[7][2] = {{-360, 360}, {-60, 120},  {-360, 360}, {-30, 210},
                                  {-360, 360}, {-110, 110}, {-360, 360}};
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    arm.joints[i].min_rad = radians_from_degrees(range_deg[i][0]);
    arm.joints[i].max_rad = radians_from_degrees(range_deg[i][1]);
  }
  return arm;
}

}  // namespace armcal
