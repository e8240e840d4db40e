// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/core/random.h"
#include "armcal/simulation/arm_state.h"

namespace armcal {

/// Links that are warmer or colder than when they were what the drawing says, and the arm knows
/// nothing of it: lengths d, b, a grow in proportion. theory/virtual_arm.md eq. (10)
struct ThermalExpansion {
  double expansion_per_K = 0.0;
  double temperature_K = 0.0;    ///< of the whole arm, above the reference temperature
  double u_temperature_K = 0.0;  ///< standard deviation of the links from that

  [[nodiscard]] bool is_on() const {
    return expansion_per_K != 0.0 && (temperature_K != 0.0 || u_temperature_K > 0.0);
  }
  /// 3 K, the most that makers allow a room to be unsteady, with 1 K between links; 5e-6 per K for
  /// tubes of carbon fibre (about 1e-6) between joints of aluminium (23e-6).
  [[nodiscard]] static ThermalExpansion typical();
};

/// Relative growth of each link, base to tip.
[[nodiscard]] std::vector<double> drawn_expansion(int joint_count, const ThermalExpansion& thermal,
                                                  RandomStream& random);

void add_expansion(ArmState& state, const std::vector<double>& growth);

}  // namespace armcal
