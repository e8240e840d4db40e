// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/thermal_expansion.h"

namespace armcal {

ThermalExpansion ThermalExpansion::typical() {
  return {.expansion_per_K = 5e-6, .temperature_K = 3.0, .u_temperature_K = 1.0};
}

std::vector<double> drawn_expansion(int joint_count, const ThermalExpansion& thermal,
                                    RandomStream& random) {
  std::vector<double> growth;
  for (int i = 0; i < joint_count; ++i) {
    const double warmer_K = thermal.temperature_K + thermal.u_temperature_K * random.normal();
    growth.push_back(thermal.expansion_per_K * warmer_K);
  }
  return growth;
}

void add_expansion(ArmState& state, const std::vector<double>& growth) {
  for (std::size_t i = 0; i < growth.size(); ++i) state.links[i].way_mm *= 1.0 + growth[i];
}

}  // namespace armcal
