// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/comparison/method.h"
#include "armcal/symmetric_point/analysis.h"

namespace armcal {

/// Postures at which the arm was read: one for every point that the reference machine took.
[[nodiscard]] int count_readings(const SymmetricPointProcedure& carried_out);

/// @throws NumericalError where the raw readings cannot be reduced or determine nothing
[[nodiscard]] SymmetricPointAnalysis analysed(const SymmetricPointProcedure& procedure,
                                              const ArmModel& nominal);

/// @throws NumericalError unless it converged
[[nodiscard]] FoundArm found_arm(const Adjustment& adjustment);

}  // namespace armcal
