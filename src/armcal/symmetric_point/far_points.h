// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace armcal {

/// A point so far off the others that it is most likely a blunder: another stop, a slipped probe.
struct FarPoint {
  std::size_t index = 0;
  double distance_mm = 0.0;  ///< from the middle of its repeats, or from the circle of the others
  double usual_mm = 0.0;     ///< what the others are off, median (repeats) or rms (arc)
};

/// Repeats of both ends of a half turn that lie far from the median point of their end: more than
/// 8 * 1.4826 times the median distance of all (theory/symmetric_point.md eq. (25)). With two
/// repeats at each end, those of the end that spreads so much more than the other; of two repeats
/// none can be told from the other, so both are named. Needs three distances: nothing from 2 + 1.
/// @return indices count the points of `end_a` first, then those of `end_b`
[[nodiscard]] std::vector<FarPoint> far_repeats(std::span<const Eigen::Vector3d> end_a,
                                                std::span<const Eigen::Vector3d> end_b);

/// Points of an arc without which the rest would be a better circle than chance allows: worst
/// first, until nothing is left to gain. theory/symmetric_point.md eq. (26). Needs 7 points.
[[nodiscard]] std::vector<FarPoint> far_points_of_arc(std::span<const Eigen::Vector3d> points);

}  // namespace armcal
