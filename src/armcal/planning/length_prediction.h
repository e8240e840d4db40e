// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "armcal/planning/half_turn_candidates.h"

namespace armcal {

/// Pairs of postures that an arm can take, drawn at random: where lengths are measured with it.
struct PosturePair {
  Eigen::VectorXd first_rad;
  Eigen::VectorXd second_rad;
};

/// @param room  its surroundings keep postures away, its volume keeps tips inside; its grid and
/// joints are not used
/// @throws ImpossiblePlan where nearly no posture is free
[[nodiscard]] std::vector<PosturePair> random_pairs(const ArmModel& arm, const HalfTurnRoom& room,
                                                    int count, std::uint64_t seed);

/// Root mean square of the standard uncertainties that uncertain parameters give the lengths
/// between the tips of each pair, mm. theory/complete_symmetric_point.md eq. (12).
/// @param unknowns    table indices of the uncertain parameters
/// @param covariance  of these
[[nodiscard]] double predicted_length_error_mm(const ArmModel& arm, std::span<const int> unknowns,
                                               const Eigen::MatrixXd& covariance,
                                               std::span<const PosturePair> pairs);

/// Root mean square of the differences of the lengths that two arms measure, mm.
[[nodiscard]] double length_error_mm(const ArmModel& arm, const ArmModel& truth,
                                     std::span<const PosturePair> pairs);

}  // namespace armcal
