// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "armcal/verification/decision_rule.h"
#include "armcal/verification/maximum_permissible_error.h"
#include "armcal/verification/test_result.h"

namespace armcal {

/// A result held against its limit. The numbers below are those of the value that decides: the
/// worst verdict, among equals the largest share of its limit.
struct Judged {
  TestResult result;
  Verdict verdict = Verdict::not_judged;
  std::optional<double> value_mm;  ///< that decides; differs from the result's own, the largest,
                                   ///< only where the limit depends on the length
  std::optional<double> mpe_mm;
  std::optional<double> U_mm;
  std::optional<double> share_of_mpe;  ///< |value| / MPE
  std::optional<double> conformance_probability;
  std::optional<std::size_t> deciding_part;  ///< of a limit that depends on the length
};

/// Judges a result by a rule.
///
/// Where parts have lengths, each is judged against MPE(L) with its own uncertainty; elsewhere the
/// reported value is. Incomplete results are judged too: what they lack they say themselves.
/// Without a limit, or without a value: not_judged.
/// @param uncertainties  one for all, or one for each part of a result whose parts have lengths
/// @throws std::invalid_argument for another number of uncertainties, or a limit that depends on a
/// length for a result that has none
[[nodiscard]] Judged judge(const TestResult& result,
                           const std::optional<MaximumPermissibleError>& mpe,
                           std::span<const ExpandedUncertainty> uncertainties,
                           const DecisionRule& rule);
[[nodiscard]] Judged judge(const TestResult& result,
                           const std::optional<MaximumPermissibleError>& mpe,
                           const ExpandedUncertainty& uncertainty, const DecisionRule& rule);

}  // namespace armcal
