// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/report/document.h"
#include "armcal/symmetric_point/analysis.h"

namespace armcal {

[[nodiscard]] Json json_result(const SymmetricPointAnalysis& analysis);

/// The whole result for a terminal or a mail: readings, chain, adjustment, claims, findings,
/// leakage in brief.
[[nodiscard]] std::string text_result(const SymmetricPointAnalysis& analysis);

/// What the analysis found, a sentence or two each: contradicted claims, failed checks, readings
/// that nothing checks, signs, parameters that the readings cannot see.
[[nodiscard]] std::vector<std::string> findings(const SymmetricPointAnalysis& analysis);

// Sections of the text, for those who tell the story in another order.
[[nodiscard]] std::string readings_text(const SymmetricPointAnalysis& analysis);
[[nodiscard]] std::string parameters_text(const SymmetricPointAnalysis& analysis);
[[nodiscard]] std::string claims_text(const SymmetricPointAnalysis& analysis);
/// The entries that matter: each assumption whose plausible error (0.1 mm or 0.5 mrad) shifts a
/// recovered parameter by more than 0.01 mm. @param most_columns  the strongest of them
[[nodiscard]] std::string leakage_text(const SymmetricPointAnalysis& analysis,
                                       std::size_t most_columns);

}  // namespace armcal
