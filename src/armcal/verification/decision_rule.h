// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "armcal/verification/verdict.h"

namespace armcal {

/// Between which values a thing conforms. A side left out has no limit; a value on a limit
/// conforms.
struct ToleranceLimits {
  std::optional<double> lower;
  std::optional<double> upper;

  /// -MPE and +MPE, for errors with a sign.
  [[nodiscard]] static ToleranceLimits about_zero(double mpe) { return {-mpe, mpe}; }
  /// At most MPE, for what cannot be negative: form, a cloud's size, a standard deviation.
  [[nodiscard]] static ToleranceLimits at_most(double mpe) { return {{}, mpe}; }
};

/// Uncertainty of a test value: the test's, not the arm's.
struct ExpandedUncertainty {
  double standard = 0.0;
  double coverage_factor = 2.0;

  [[nodiscard]] double expanded() const { return coverage_factor * standard; }
};

enum class DecisionKind {
  iso14253_1,               ///< guard band U: pass inside the limits by U, fail outside by U
  conformance_probability,  ///< guard band z_p u, the form of the 2017 edition of ISO 14253-1
  simple_acceptance,        ///< pass inside the limits, else fail; U plays no part
  guard_band,               ///< pass inside the limits by a chosen share of U, else fail
};
/// The name as written in files and JSON: iso14253-1, conformance-probability, ...
[[nodiscard]] std::string_view to_string(DecisionKind kind);
/// The rule in one sentence, for reports.
[[nodiscard]] std::string_view explain(DecisionKind kind);

struct DecisionRule {
  DecisionKind kind = DecisionKind::iso14253_1;
  double probability = 0.95;  ///< of conformance_probability: least probability to pass
  double guard_factor = 1.0;  ///< of guard_band: w = guard_factor * U; negative widens the limits
};

/// Width of the guard band. theory/verification.md eq. (11), (13)
/// @throws std::invalid_argument for a probability outside [0.5, 1), a guard factor that is not
/// finite, or an uncertainty that is negative or not finite
[[nodiscard]] double guard_band(const DecisionRule& rule, const ExpandedUncertainty& uncertainty);

/// Judges one value. theory/verification.md eq. (11).
///
/// pass where lower + g <= value <= upper - g (no value passes where 2 g is larger than the
/// tolerance); with the two rules of ISO 14253-1 fail only where value < lower - g or
/// value > upper + g, and undecided between; with the others fail wherever it does not pass. A
/// value on a bound to the rounding of its numbers counts as on it. A value that is not finite is
/// not judged. What is taken from public descriptions of the standard: the three zones and the
/// guard factors 1.28, 1.65, 2.33, 3.09 of the 2017 edition; our reading: that equality passes.
/// @throws std::invalid_argument as `guard_band`, and for limits that are both left out or cross
[[nodiscard]] Verdict decide(double value, const ExpandedUncertainty& uncertainty,
                             const ToleranceLimits& limits, const DecisionRule& rule);

/// Probability that the true value lies within the limits, for a normal distribution of standard
/// deviation u about the measured value (JCGM 106:2012, 7.2-7.4). theory/verification.md eq. (12).
/// u = 0: 1 inside, 0 outside. One minus it is the specific consumer's risk of what is accepted,
/// and it is itself the specific producer's risk of what is rejected (3.3.13, 3.3.14).
/// @throws std::invalid_argument for a negative u, or limits that are both left out or cross
[[nodiscard]] double conformance_probability(double value, double u, const ToleranceLimits& limits);

/// The measured value at which the probability of exceeding `upper` is as given, where the
/// uncertainty grows with the value: y = upper / (1 - z u_relative) (JCGM 106:2012, 8.3.3,
/// example).
/// @throws std::invalid_argument unless probability is in (0, 1) and z u_relative below 1
[[nodiscard]] double action_limit(double upper, double u_relative, double probability);

}  // namespace armcal
