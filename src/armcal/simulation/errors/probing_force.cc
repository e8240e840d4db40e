// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/probing_force.h"

namespace armcal {

ProbingForce ProbingForce::typical() {
  return {.force_N = 2.0, .arm_mm_per_N = 0.006, .stylus_mm_per_N = 0.004};
}

Eigen::Vector3d yield_to(const ProbingForce& probing, const Eigen::Vector3d& push,
                         const Eigen::Vector3d& stylus) {
  const Eigen::Vector3d across = push - stylus.dot(push) * stylus;
  return -probing.force_N * (probing.arm_mm_per_N * push + probing.stylus_mm_per_N * across);
}

}  // namespace armcal
