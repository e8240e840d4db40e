// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/methods/registry.h"

namespace armcal {

std::vector<Method> baseline_methods() {
  return {{.name = "nominal",
           .title = "nominal arm",
           .needs = "nothing",
           .take = [](const Bench& bench) -> TakenReadings {
             return {0, [nominal = bench.arm.nominal()] { return FoundArm{.arm = nominal}; }};
           }}};
}

}  // namespace armcal
