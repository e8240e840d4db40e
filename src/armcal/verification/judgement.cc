// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/judgement.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace armcal {
namespace {

bool have_lengths(const TestResult& result) {
  if (result.parts.empty()) return false;
  for (const ResultPart& part : result.parts) {
    if (!part.length_mm) return false;
  }
  return true;
}

void check(const TestResult& result, const std::optional<MaximumPermissibleError>& mpe,
           std::size_t uncertainties) {
  const bool each = have_lengths(result) && uncertainties == result.parts.size();
  if (uncertainties != 1 && !each) {
    throw std::invalid_argument(
        fmt::format("{}: {} uncertainties for {} values; give one for all, or one for each length",
                    result.name, uncertainties, result.parts.size()));
  }
  if (mpe && mpe->depends_on_length() && result.value_mm && !have_lengths(result)) {
    throw std::invalid_argument(fmt::format(
        "{}: the limit {} depends on a length, and this test has none", result.name, mpe->text()));
  }
}

// Of one value; the result it belongs to is left out.
Judged judged_value(double value_mm, bool is_signed, double mpe_mm,
                    const ExpandedUncertainty& uncertainty, const DecisionRule& rule) {
  const ToleranceLimits limits =
      is_signed ? ToleranceLimits::about_zero(mpe_mm) : ToleranceLimits::at_most(mpe_mm);
  Judged judged;
  judged.verdict = decide(value_mm, uncertainty, limits, rule);
  judged.value_mm = value_mm;
  judged.mpe_mm = mpe_mm;
  judged.U_mm = uncertainty.expanded();
  judged.share_of_mpe = std::abs(value_mm) / mpe_mm;
  judged.conformance_probability = conformance_probability(value_mm, uncertainty.standard, limits);
  return judged;
}

bool decides_over(const Judged& one, const Judged& other) {
  if (one.verdict != other.verdict) return one.verdict > other.verdict;
  return one.share_of_mpe > other.share_of_mpe;
}

Judged judged_lengths(const TestResult& result, const MaximumPermissibleError& mpe,
                      std::span<const ExpandedUncertainty> uncertainties,
                      const DecisionRule& rule) {
  Judged deciding;
  for (std::size_t i = 0; i < result.parts.size(); ++i) {
    const ResultPart& part = result.parts[i];
    const ExpandedUncertainty& uncertainty = uncertainties[uncertainties.size() == 1 ? 0 : i];
    Judged judged =
        judged_value(part.value_mm, result.is_signed, mpe.at(*part.length_mm), uncertainty, rule);
    judged.deciding_part = i;
    if (i == 0 || decides_over(judged, deciding)) deciding = judged;
  }
  return deciding;
}

}  // namespace

Judged judge(const TestResult& result, const std::optional<MaximumPermissibleError>& mpe,
             std::span<const ExpandedUncertainty> uncertainties, const DecisionRule& rule) {
  check(result, mpe, uncertainties.size());
  Judged judged;
  if (result.value_mm && mpe) {
    judged = have_lengths(result) ? judged_lengths(result, *mpe, uncertainties, rule)
                                  : judged_value(*result.value_mm, result.is_signed, mpe->at(0.0),
                                                 uncertainties.front(), rule);
  } else {
    judged.value_mm = result.value_mm;
    if (uncertainties.size() == 1) judged.U_mm = uncertainties.front().expanded();
  }
  judged.result = result;
  return judged;
}

Judged judge(const TestResult& result, const std::optional<MaximumPermissibleError>& mpe,
             const ExpandedUncertainty& uncertainty, const DecisionRule& rule) {
  return judge(result, mpe, std::span(&uncertainty, 1), rule);
}

}  // namespace armcal
