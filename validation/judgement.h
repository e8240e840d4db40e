// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "trial.h"

namespace armcal::validation {

/// One figure beside what it must be.
struct Finding {
  std::string what;
  double value = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  std::string note;  ///< which parameter it is, say

  [[nodiscard]] bool passes() const { return lowest <= value && value <= highest; }
};

/// Holds the trials of one scenario against the bounds of docs/validation.md. With fewer than 1,000
/// of them bounds are as wide as chance makes them for that number (99.9 %).
[[nodiscard]] std::vector<Finding> judge(const Plan& plan, std::span<const Trial> trials);

/// Share of truths that intervals of +-1.96 u hold where u is widened by sigma0 if that exceeds 1
/// and the stated uncertainties are right. theory/identification.md eq. (19)
[[nodiscard]] double expected_coverage(double degrees_of_freedom);
/// Mean of sigma0 where the stated uncertainties are right.
[[nodiscard]] double expected_sigma0(double degrees_of_freedom);

/// How few and how many of `count` successes of probability 0.95 chance gives (99.9 %, both sides
/// together).
struct Band {
  int fewest = 0;
  int most = 0;
};
[[nodiscard]] Band binomial_band(int count);

}  // namespace armcal::validation
