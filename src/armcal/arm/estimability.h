// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/rank_analysis.h"

namespace armcal {

/// The order in which parameters are wanted as unknowns, most wanted first. What data cannot tell
/// apart is held from the end of this order: zero1, d2 and the last zero (conventions: they move
/// the base frame or turn the tip about the last axis), then beta, then d against b. On links whose
/// axes are within 10 deg of parallel beta is wanted and b and d are not (Hayati).
/// theory/kinematics.md, "What can be identified".
[[nodiscard]] std::vector<int> wanted_order(const ArmModel& arm, const ParameterTable& table);

/// Why a parameter is not asked for unless the user insists, whatever the readings: zero1 and d2
/// only move the base frame, as does b2 on a link of length a2 whose axes are within 10 deg of
/// parallel, and beta is for such axes alone. Nothing for all others.
[[nodiscard]] std::optional<std::string> held_by_convention(const ArmModel& arm,
                                                            const Parameter& parameter);

/// A column that the data cannot tell from others, in words: "zero6 moves every reading like a7 and
/// b7".
/// @param names  of all columns of the analysed Jacobian
[[nodiscard]] std::string describe(const DependentColumn& dependent, const RankAnalysis& analysis,
                                   const std::vector<std::string>& names);

}  // namespace armcal
