// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/check_trend.h"

#include <cmath>

namespace armcal {

std::vector<RuleViolation> CheckTrend::violations_now() const {
  std::vector<RuleViolation> now;
  for (const RuleViolation& each : violations) {
    if (each.at + 1 == points.size()) now.push_back(each);
  }
  return now;
}

std::optional<double> CheckTrend::days_to_limit() const {
  if (!drift || !drift->is_significant || !limit_mm) return std::nullopt;
  if (!is_signed && drift->mm_per_day < 0.0) return std::nullopt;
  if (std::abs(points.back().value_mm) > *limit_mm) return std::nullopt;
  return drift->days_to(*limit_mm);
}

CheckTrend judged(CheckTrend trend) {
  std::vector<double> values;
  std::vector<TimedValue> history;
  constexpr double kDay_s = 86400.0;
  for (const TrendPoint& point : trend.points) {
    values.push_back(point.value_mm);
    history.push_back({static_cast<double>(point.time_s) / kDay_s, point.value_mm});
  }
  if (values.size() >= trend.baseline) {
    trend.limits = limits_of_baseline(std::span(values).first(trend.baseline));
    trend.violations = violations_of(values, *trend.limits);
  }
  trend.drift = drift_of(history);
  return trend;
}

}  // namespace armcal
