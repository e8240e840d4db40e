// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/core/progress.h"
#include "armcal/planning/half_turn_candidates.h"

namespace armcal {

/// An order of half turns in which few joints have to be set between readings. The joints behind
/// the one that turns have to be set; those before it only carry the tip along and may stay where
/// the reading before left them. Starting from an order by joint and angles, pieces are turned
/// round (2-opt) and single readings moved as long as fewer joints move or, among equals, less far.
/// @return places in `turns`, in the order of reading
[[nodiscard]] std::vector<int> reading_order(std::span<const HalfTurn> turns,
                                             const Monitor& monitor = {});

/// Joints that have to be set before each reading when all others stay, in the order given.
[[nodiscard]] int joints_to_set(std::span<const HalfTurn> turns, std::span<const int> order);

}  // namespace armcal
