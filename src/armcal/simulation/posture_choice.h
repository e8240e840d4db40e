// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal {

/// Readings of an encoder between which postures are drawn.
struct JointRange {
  double low_rad = 0.0;
  double high_rad = 0.0;
};

/// From stop to stop, but no more than one turn: the middle one where there are two stops, the one
/// next to the stop where there is one, the one about 0 where there is none.
[[nodiscard]] JointRange range_in_use(const Joint& joint);

/// Distance of two postures: the root of the sum of squares of what each joint has to turn, the
/// short way round.
[[nodiscard]] double joint_distance_rad(const Eigen::VectorXd& one, const Eigen::VectorXd& other);

/// `count` of the candidates: the first, then each time the one that is farthest from all chosen
/// before (the first of equals). @param count  at most the number of candidates
[[nodiscard]] std::vector<Eigen::VectorXd> most_different(std::vector<Eigen::VectorXd> candidates,
                                                          std::size_t count);

}  // namespace armcal
