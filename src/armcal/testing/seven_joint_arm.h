// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/arm/arm_model.h"
#include "armcal/core/units.h"

namespace armcal::testing {

/// Proportions of a 2.5 m arm of seven joints, with stops, as in
/// examples/arms/seven-joint.arm.toml.
inline ArmModel seven_joint_arm() {
  ArmModel arm;
  arm.name = "seven-joint measuring arm";
  arm.links.resize(6);
  for (std::size_t i = 0; i < 6; ++i) {
    arm.links[i].alpha_rad = radians_from_degrees(i % 2 == 0 ? 90.0 : -90.0);
  }
  arm.links[0].d_mm = 300.0;
  arm.links[1].b_mm = 600.0;
  arm.links[2].a_mm = 45.0;
  arm.links[3].b_mm = 500.0;
  arm.links[4].a_mm = 35.0;
  arm.links[5].b_mm = 100.0;
  arm.tip.a_mm = 30.0;
  arm.tip.d_mm = 150.0;
  constexpr double kStops_deg[7][2] = {{-360, 360}, {-60, 120},  {-360, 360}, {-30, 210},
                                       {-360, 360}, {-110, 110}, {-360, 360}};
  for (const auto& [low, high] : kStops_deg) {
    Joint joint;
    joint.min_rad = radians_from_degrees(low);
    joint.max_rad = radians_from_degrees(high);
    arm.joints.push_back(joint);
  }
  return arm;
}

}  // namespace armcal::testing
