// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/verification/control_chart.h"
#include "armcal/verification/drift.h"

namespace armcal {

/// One value of one check of a history.
struct TrendPoint {
  std::int64_t check = 0;   ///< number of the check
  std::int64_t time_s = 0;  ///< UTC, seconds since 1970
  double value_mm = 0.0;
};

/// One value of an arm over its checks: where it lies, what is unusual about it, where it goes.
struct CheckTrend {
  std::string name;  ///< max_deviation, ..
  std::vector<TrendPoint> points;
  std::optional<double> limit_mm;  ///< of the last check
  bool is_signed = false;
  std::size_t baseline = 0;             ///< first points that centre and sigma come from
  std::optional<ControlLimits> limits;  ///< nothing before the baseline is complete
  std::vector<RuleViolation> violations;
  std::optional<Drift> drift;

  /// Of the last check: what a user should hear of now.
  [[nodiscard]] std::vector<RuleViolation> violations_now() const;
  /// Days until the drift reaches the limit; nothing where it is not significant, moves away from
  /// it, there is none, or the last check exceeds it already.
  [[nodiscard]] std::optional<double> days_to_limit() const;
};

/// Judges a history. The chart begins with the first `baseline` points; rules are applied to all.
/// @param trend  with name, points (by time), limit, is_signed and baseline filled
/// @throws std::invalid_argument for a baseline of fewer than 2
[[nodiscard]] CheckTrend judged(CheckTrend trend);

}  // namespace armcal
