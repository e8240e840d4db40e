// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "armcal/verification/measured_length.h"
#include "armcal/verification/test_result.h"

namespace armcal::iso10360_12 {

/// Length measurement error E_Uni of ISO 10360-12:2016, unidirectional.
///
/// Measured minus calibrated length, where both ends are touched from the same direction (a ball
/// bar's centres, equal faces of a step gauge), so the probe's diameter does not enter. The error
/// of largest magnitude is reported; all are parts, to be judged one by one against MPE(L). Any
/// layout is accepted; what it lacks of the standard's is told (`missing_lengths`).
/// theory/verification.md eq. (4)
/// @param reach_mm  of the arm, where known
[[nodiscard]] TestResult length_error_uni(std::span<const MeasuredLength> lengths,
                                          std::optional<double> reach_mm = {});

}  // namespace armcal::iso10360_12
