// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/warm_up_drift.h"

#include "armcal/core/units.h"

namespace armcal {

WarmUpDrift WarmUpDrift::typical() {
  return {.u_zero_rad = radians_from_arcseconds(2.0), .u_length = 5e-6};
}

DrawnDrift drawn_drift(int joint_count, const WarmUpDrift& drift, RandomStream& random) {
  DrawnDrift drawn;
  for (int i = 0; i < joint_count; ++i) {
    drawn.zero_rad.push_back(drift.u_zero_rad * random.normal());
    drawn.growth.push_back(drift.u_length * random.normal());
  }
  return drawn;
}

void add_drift(ArmState& state, const DrawnDrift& drift, const std::vector<Joint>& joints,
               double share) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    state.joints[i].angle_rad += joints[i].direction * share * drift.zero_rad[i];
    state.links[i].way_mm *= 1.0 + share * drift.growth[i];
  }
}

}  // namespace armcal
