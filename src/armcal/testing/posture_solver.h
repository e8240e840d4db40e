// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal::testing {

/// Encoder readings that put the tip on `target_mm`, near `start`, moving only the given joints
/// (from 1). Damped Newton; the caller checks that it arrived.
inline std::vector<double> posture_at(const ForwardKinematics& kinematics,
                                      const Eigen::Vector3d& target_mm, std::vector<double> start,
                                      const std::vector<int>& joints) {
  for (int i = 0; i < 200; ++i) {
    const TipLinearisation at = kinematics.linearise(start);
    const Eigen::Vector3d missing = target_mm - at.tip_mm;
    if (missing.norm() < 1e-11) break;
    Eigen::MatrixXd jacobian(3, static_cast<Eigen::Index>(joints.size()));
    for (std::size_t k = 0; k < joints.size(); ++k) {
      jacobian.col(static_cast<Eigen::Index>(k)) = at.J_tip_encoder.col(joints[k] - 1);
    }
    Eigen::VectorXd step = shortest_solution(jacobian, missing);
    const double largest = step.lpNorm<Eigen::Infinity>();
    if (largest > 0.2) step *= 0.2 / largest;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      start[static_cast<std::size_t>(joints[k] - 1)] += step(static_cast<Eigen::Index>(k));
    }
  }
  return start;
}

}  // namespace armcal::testing
