// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace armcal {

/// A value at a time.
struct TimedValue {
  double time_days = 0.0;  ///< from any origin
  double value_mm = 0.0;
};

/// Over which drifts are told.
inline constexpr double kMonth_days = 30.0;

/// Straight line through a history.
struct Drift {
  std::size_t count = 0;
  double mm_per_day = 0.0;
  double u_mm_per_day = 0.0;  ///< from the scatter about the line
  double now_mm = 0.0;        ///< of the line at the last time
  /// Is the slope beyond what scatter alone gives in 95 % of histories (Student's t, count - 2
  /// degrees of freedom)?
  bool is_significant = false;

  /// Days until the line leaves +-limit, 0 where it is outside now; nothing where it does not go
  /// there.
  [[nodiscard]] std::optional<double> days_to(double limit_mm) const;
};

/// Least-squares line. theory/interim_check.md eq. (4)-(5)
/// @return nothing for fewer than 3 values, or values of one time only
[[nodiscard]] std::optional<Drift> drift_of(std::span<const TimedValue> history);

}  // namespace armcal
