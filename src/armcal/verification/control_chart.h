// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace armcal {

/// Where a value lies that nothing has happened to, and how widely: the centre line of a chart of
/// individual values and one standard deviation.
struct ControlLimits {
  double center = 0.0;
  double sigma = 0.0;  ///< 0 where all values of the baseline are equal: then nothing is judged

  [[nodiscard]] double lower() const { return center - 3.0 * sigma; }
  [[nodiscard]] double upper() const { return center + 3.0 * sigma; }
};

/// Expected range of two values of a normal distribution, in standard deviations: 2 / sqrt(pi),
/// 1.128 in the tables.
inline constexpr double kRangeOfTwo_sigma = 1.1283791670955126;

/// Centre and sigma of a baseline, in its order: the mean, and the mean of the ranges of
/// neighbours over 1.128. A slow drift, which would inflate a standard deviation, hardly widens
/// that. theory/interim_check.md eq. (2)-(3)
/// @throws std::invalid_argument for fewer than 2 values or one that is not finite
[[nodiscard]] ControlLimits limits_of_baseline(std::span<const double> baseline);

/// The four rules of the Western Electric handbook (1956), each for one side of the centre line.
enum class ControlRule {
  beyond_three_sigma = 1,       ///< one value beyond 3 sigma
  two_of_three_beyond_two = 2,  ///< two of three in succession beyond 2 sigma
  four_of_five_beyond_one = 3,  ///< four of five in succession beyond 1 sigma
  eight_on_one_side = 4,        ///< eight in succession on one side
};

enum class Side { below, above };

/// A rule that is broken with this value, by it and those before it.
struct RuleViolation {
  ControlRule rule = ControlRule::beyond_three_sigma;
  Side side = Side::above;
  std::size_t at = 0;  ///< index of the value, which itself is on that side and beyond
};

/// "8 checks in a row above the centre line (rule 4)".
[[nodiscard]] std::string explain(const RuleViolation& violation);

/// Every violation, by value and then by rule. Where nothing has happened and the limits are known,
/// normal values break rule 1 once in 370 on average, one of the four once in 91.75 (Champ and
/// Woodall, Technometrics 29 (1987) 393-399); with limits from a short baseline more often.
[[nodiscard]] std::vector<RuleViolation> violations_of(std::span<const double> values,
                                                       const ControlLimits& limits);

}  // namespace armcal
