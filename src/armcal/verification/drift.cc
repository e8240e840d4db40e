// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/drift.h"

#include <algorithm>
#include <cmath>

#include "armcal/numerics/distributions.h"

namespace armcal {

std::optional<double> Drift::days_to(double limit_mm) const {
  if (std::abs(now_mm) >= limit_mm) return 0.0;
  if (mm_per_day == 0.0) return std::nullopt;
  return (std::copysign(limit_mm, mm_per_day) - now_mm) / mm_per_day;
}

std::optional<Drift> drift_of(std::span<const TimedValue> history) {
  if (history.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(history.size());
  double mean_time = 0.0;
  double mean_value = 0.0;
  double largest = 0.0;
  double last_time = history.front().time_days;
  for (const TimedValue& each : history) {
    mean_time += each.time_days / count;
    mean_value += each.value_mm / count;
    largest = std::max(largest, std::abs(each.value_mm));
    last_time = std::max(last_time, each.time_days);
  }
  double tt = 0.0;
  double tv = 0.0;
  for (const TimedValue& each : history) {
    const double time = each.time_days - mean_time;
    tt += time * time;
    tv += time * (each.value_mm - mean_value);
  }
  if (!(tt > 0.0)) return std::nullopt;

  Drift drift;
  drift.count = history.size();
  // Equal values differ from their mean by rounding: that is no slope.
  constexpr double kRounding = 1e-14;
  drift.mm_per_day = std::abs(tv) > kRounding * largest * std::sqrt(tt * count) ? tv / tt : 0.0;
  const auto line = [&](double time) { return mean_value + drift.mm_per_day * (time - mean_time); };
  double squares = 0.0;
  for (const TimedValue& each : history) {
    squares += std::pow(each.value_mm - line(each.time_days), 2);
  }
  drift.u_mm_per_day = std::sqrt(squares / (count - 2.0) / tt);
  drift.now_mm = line(last_time);
  constexpr double kBothTails = 0.975;
  drift.is_significant =
      std::abs(drift.mm_per_day) > student_t_quantile(kBothTails, count - 2.0) * drift.u_mm_per_day;
  return drift;
}

}  // namespace armcal
