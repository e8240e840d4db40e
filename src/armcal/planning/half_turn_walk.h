// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "armcal/planning/half_turn_candidates.h"

namespace armcal {

/// Carries out half turns one after the other and moves no joint that need not move: those before
/// the joint that turns, and that joint itself, stay where the reading before left them - if both
/// ends are then free, within limits and volume, and `is_as_good` has nothing against it. Otherwise
/// the posture is the planned one, from whichever end is nearer.
/// @param turns  in the order of reading
/// @param is_as_good  is this half turn as good a reading as the planned one?
[[nodiscard]] std::vector<HalfTurn> walk_through(
    const ArmModel& arm, const HalfTurnRoom& room, std::span<const HalfTurn> turns,
    const std::function<bool(const HalfTurn& tried, const HalfTurn& planned)>& is_as_good);

/// How many joints differ between two postures.
[[nodiscard]] int joints_moved(const Eigen::VectorXd& from_rad, const Eigen::VectorXd& to_rad);

/// Joints that are set between the readings of a walk, those that make the half turns not counted.
[[nodiscard]] int joints_moved(std::span<const HalfTurn> walk);

}  // namespace armcal
