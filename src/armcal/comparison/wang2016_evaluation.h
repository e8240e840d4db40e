// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/comparison/method.h"
#include "armcal/symmetric_point/analysis.h"

namespace armcal {

// What can be made of the readings of the 2016 paper's procedure
// (simulation/symmetric_procedure.h). All take the zeros of joints 2 and 4 from the searches, by
// the adjustment.

/// Seven parameters by least squares over all readings.
[[nodiscard]] FoundArm wang2016_adjusted(const SymmetricPointAnalysis& analysis);

/// Length after length from one half turn each, read with the model.
/// @throws NumericalError where the chain breaks
[[nodiscard]] FoundArm wang2016_chain(const SymmetricPointAnalysis& analysis);

/// Table 2 of the paper to the letter: b7 is the radius of the last circle and d7 half of l_PP1,
/// the same length twice. States no uncertainties.
[[nodiscard]] FoundArm wang2016_as_printed(const SymmetricPointAnalysis& analysis);

}  // namespace armcal
