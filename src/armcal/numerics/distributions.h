// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal {

// Distribution functions and quantiles for tests and coverage factors. Relative accuracy 1e-13 or
// better against the exact tables in the reference data. Degrees of freedom need not be integers
// (GUM, G.4). A probability outside (0, 1), or degrees of freedom that are not positive, throw
// std::domain_error.

[[nodiscard]] double normal_cdf(double x);
[[nodiscard]] double normal_quantile(double probability);
[[nodiscard]] double student_t_quantile(double probability, double degrees_of_freedom);
[[nodiscard]] double chi_squared_quantile(double probability, double degrees_of_freedom);
/// Probability that a chi-squared variable exceeds `x`.
[[nodiscard]] double chi_squared_survival(double x, double degrees_of_freedom);
[[nodiscard]] double f_quantile(double probability, double numerator, double denominator);
/// Probability that an F variable exceeds `x`.
[[nodiscard]] double f_survival(double x, double numerator, double denominator);

}  // namespace armcal
