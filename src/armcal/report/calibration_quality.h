// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal {

/// Do residuals scatter more than the stated uncertainties say? Then every uncertainty is widened.
/// @param chi2_probability  of a larger chi-squared by chance; below 0.1 % it was not chance
[[nodiscard]] constexpr bool scatters_more_than_stated(double sigma0, double chi2_probability) {
  return sigma0 > 1.0 && chi2_probability < 1e-3;
}

/// Is the model too small for the readings?
/// @param check_coverage  share of held-out rows in their predicted 95 % regions
[[nodiscard]] constexpr bool is_model_too_small(double check_coverage) {
  return check_coverage < 0.9;
}

}  // namespace armcal
