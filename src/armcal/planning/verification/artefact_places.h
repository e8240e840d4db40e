// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "armcal/planning/verification/sphere_pattern.h"
#include "armcal/planning/verification/touch_search.h"
#include "armcal/planning/verification/tried_places.h"
#include "armcal/planning/verification_plan.h"

namespace armcal {

/// What is planned in multiples of: bars and calibrated lengths come so.
inline constexpr double kRoundLength_mm = 50.0;

/// Distances from the origin of the first joint.
struct Shell {
  double inner_mm = 0.0;
  double outer_mm = 0.0;
};

using SpherePattern = std::function<std::vector<Eigen::Vector3d>(const Eigen::Vector3d& pole)>;

// Places drawn at random in the order of the stream, up to `most` that will do; empty where none of
// some hundred or thousand does, and then `tried` tells why. Spheres and seats stand at most 45 deg
// above or below the level of the first joint. Their poles and axes lead up, slanting back to the
// first axis or level to it, whichever works first.

/// Spheres of which the tip reaches the whole pattern. @param size  its centre is not read
[[nodiscard]] std::vector<PlannedSphere> sphere_places(
    const TouchSearch& search, const Shell& shell, const SphereToProbe& size,
    const SpherePattern& pattern, std::size_t most, RandomStream& random, TriedPlaces& tried);

/// A seat that the tip reaches with the arm in at least so many postures, which are returned with
/// it: those that differ most.
struct SeatPlace {
  PlannedSeat seat;
  std::vector<Eigen::VectorXd> postures_rad;
};
[[nodiscard]] std::optional<SeatPlace> seat_place(const TouchSearch& search, const Shell& shell,
                                                  std::size_t postures, RandomStream& random,
                                                  TriedPlaces& tried);

/// Bars along a direction (one way or the other) whose ends are reached for every length; all of
/// the bar is clear of bench and first axis.
/// @param direction  unit length; drawn anew for every bar where it is zero
[[nodiscard]] std::vector<PlannedBar> bar_places(const TouchSearch& search,
                                                 const Eigen::Vector3d& direction,
                                                 const std::vector<double>& lengths_mm,
                                                 std::size_t most, RandomStream& random,
                                                 TriedPlaces& tried);

/// The tip in the seat at an end of a bar. Seats open across the bar: up, or towards the first axis
/// where the bar stands upright.
[[nodiscard]] Touch seat_on(const TouchSearch& search, const PlannedBar& bar,
                            double distance_from_A_mm);

}  // namespace armcal
