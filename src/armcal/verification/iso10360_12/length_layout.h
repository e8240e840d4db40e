// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/verification/measured_length.h"

namespace armcal::iso10360_12 {

/// What 105 lengths of a length test lack: 5 calibrated lengths, each at 7 positions, each measured
/// 3 times, the longest at least 66 % of the arm's reach (asked only where the reach is known).
/// Lengths within 1 mm of each other are the same length. More lengths, positions or repeats are
/// no fault. The numbers are those of ISO 10360-2, which part 12 is said to share: our reading.
[[nodiscard]] std::vector<std::string> missing_lengths(std::span<const MeasuredLength> lengths,
                                                       std::optional<double> reach_mm);

}  // namespace armcal::iso10360_12
