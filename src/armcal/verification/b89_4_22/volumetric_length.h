// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "armcal/verification/measured_length.h"
#include "armcal/verification/test_result.h"

namespace armcal::b89_4_22 {

/// Volumetric performance of ASME B89.4.22-2004: calibrated lengths in exactly twenty placements.
///
/// Two results: the error of largest magnitude with its sign, and twice the root mean square of the
/// errors. From public descriptions: twenty deviations, twice their standard deviation; that this
/// is taken about zero is our reading. Which lengths and placements they are is not checked.
/// theory/verification.md eq. (9)
[[nodiscard]] std::vector<TestResult> volumetric_length(std::span<const MeasuredLength> lengths);

}  // namespace armcal::b89_4_22
