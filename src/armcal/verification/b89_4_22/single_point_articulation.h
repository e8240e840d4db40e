// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/verification/test_result.h"

namespace armcal::b89_4_22 {

/// A seat that does not move, and the tip's coordinates in it, one for each articulation.
struct SeatPoints {
  std::string name;
  std::vector<Eigen::Vector3d> points_mm;
  std::string where;  ///< place in the user's file; may be empty
};

enum class ReachZone { near, middle, far };
[[nodiscard]] std::string_view to_string(ReachZone zone);

/// near under 20 % of the reach, far over 80 %, middle from one to the other, both included. Public
/// descriptions name the zones; the shares are our reading.
[[nodiscard]] ReachZone zone_of(double distance_mm, double reach_mm);

/// How far repeated points of one seat stray from their mean, in space: never per axis.
/// theory/verification.md eq. (7), (8)
struct SeatScatter {
  Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
  std::vector<double> deviations_mm;  ///< distance of each point from the mean
  double largest_mm = 0.0;
  double twice_s_mm = 0.0;  ///< 2 sqrt(sum deviation^2 / (n - 1)); 0 for a single point
};
/// @throws std::invalid_argument without points
[[nodiscard]] SeatScatter scatter_in_seat(std::span<const Eigen::Vector3d> points_mm);

/// Where the arm stands, for the zones.
struct ArmReach {
  Eigen::Vector3d first_axis_origin_mm = Eigen::Vector3d::Zero();  ///< origin of its first joint
  double reach_mm = 0.0;
};

/// The first joint's origin in the base frame, and the longest conceivable reach: for arms whose
/// data sheet states none.
[[nodiscard]] ArmReach reach_of(const ArmModel& arm);

/// Single-point articulation ("SPAT") of ASME B89.4.22-2004: ten articulations in a seat, in each
/// of the zones near, middle and far.
///
/// Two results for each seat, named with its zone: largest deviation from the mean, and twice the
/// standard deviation. Every result names zones that have no seat and seats of too few points. From
/// public descriptions: the three zones, the two statistics; the formulas and ten articulations are
/// our reading. Makers use the same name for another statistic: `half_range`.
/// @throws std::invalid_argument unless the reach is finite and positive
[[nodiscard]] std::vector<TestResult> single_point_articulation(std::span<const SeatPoints> seats,
                                                                const ArmReach& arm);

}  // namespace armcal::b89_4_22
