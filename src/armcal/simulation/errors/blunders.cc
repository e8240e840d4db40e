// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/blunders.h"

namespace armcal {

Blunders Blunders::typical() { return {.share = 0.01, .size_mm = 0.1}; }

Eigen::Vector3d drawn_blunder(const Blunders& blunders, RandomStream& random) {
  if (!blunders.is_on()) return Eigen::Vector3d::Zero();
  // Always the same count of numbers, so that another share spoils the same readings and more.
  const double chance = random.uniform();
  Eigen::Vector3d direction;
  for (double& component : direction) component = random.normal();
  if (chance >= blunders.share) return Eigen::Vector3d::Zero();
  return blunders.size_mm * direction.normalized();
}

}  // namespace armcal
