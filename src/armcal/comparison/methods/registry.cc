// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/methods/registry.h"

namespace armcal {

std::vector<Method> all_methods() {
  std::vector<Method> all;
  for (const auto& family : {baseline_methods(), least_squares_methods(), population_methods()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

}  // namespace armcal
