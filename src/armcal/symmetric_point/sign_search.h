// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// Most quantities whose sign may be unknown at once: 4096 combinations.
inline constexpr std::size_t kMostUnknownSigns = 12;

/// The nominal arm with some signs turned round, and how well it then predicts the readings.
struct SignCombination {
  std::vector<std::string> turned;  ///< names whose sign differs from the nominal arm
  double misfit = 0.0;  ///< root mean square of (reading - prediction) / largest reading
  ArmModel arm;
};

/// A reversal distance has no sign, so the signs of offsets and the counting directions of joints
/// follow from the nominal arm or, where that does not know them, from all readings together: every
/// combination is tried on the nominal magnitudes. Sorted by misfit, fewer turned signs first among
/// equals. Combinations of equal misfit are mirror images that no such reading can tell apart.
/// @param unknown_signs  parameter names, and `direction4` for the counting direction of joint 4
/// @throws std::invalid_argument for an unknown name or more than kMostUnknownSigns of them
[[nodiscard]] std::vector<SignCombination> search_signs(const ArmModel& nominal,
                                                        std::span<const SymmetricReading> readings,
                                                        std::span<const std::string> unknown_signs);

/// How many combinations at the head of the sorted list are equally good (mirror images of each
/// other).
[[nodiscard]] std::size_t count_equally_good(std::span<const SignCombination> combinations);

}  // namespace armcal
