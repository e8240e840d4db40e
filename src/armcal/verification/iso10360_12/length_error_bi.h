// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "armcal/verification/measured_length.h"
#include "armcal/verification/test_result.h"

namespace armcal::iso10360_12 {

/// Length measurement error E_Bi of ISO 10360-12:2016, bidirectional.
///
/// Measured minus calibrated length, where the ends are touched from opposite directions (an end
/// gauge, an inside or outside length), so the probe's diameter enters. The error of largest
/// magnitude is reported; all are parts, to be judged one by one against MPE(L). Any layout is
/// accepted; what it lacks of the standard's is told (`missing_lengths`). theory/verification.md
/// eq. (4)
/// @param reach_mm  of the arm, where known
[[nodiscard]] TestResult length_error_bi(std::span<const MeasuredLength> lengths,
                                         std::optional<double> reach_mm = {});

}  // namespace armcal::iso10360_12
