// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/core/random.h"
#include "armcal/simulation/arm_state.h"

namespace armcal {

/// An arm that warms up after it is switched on: zeros and lengths creep towards other values, each
/// its own way. theory/virtual_arm.md eq. (14)
struct WarmUpDrift {
  double u_zero_rad = 0.0;  ///< standard deviation, over joints, of where a zero ends
  double u_length = 0.0;    ///< and of the relative growth of a link, mm/mm
  double time_constant_s = 1200.0;

  [[nodiscard]] bool is_on() const { return u_zero_rad > 0.0 || u_length > 0.0; }
  /// 2 arcsec and 5e-6 with 20 minutes. An estimate: makers say only that parts warm at different
  /// rates.
  [[nodiscard]] static WarmUpDrift typical();
};

/// Where everything ends.
struct DrawnDrift {
  std::vector<double> zero_rad;  ///< of each joint
  std::vector<double> growth;    ///< of each link, base to tip
};

[[nodiscard]] DrawnDrift drawn_drift(int joint_count, const WarmUpDrift& drift,
                                     RandomStream& random);

/// @param share  of the way gone: 1 - exp(-time / time constant)
void add_drift(ArmState& state, const DrawnDrift& drift, const std::vector<Joint>& joints,
               double share);

}  // namespace armcal
