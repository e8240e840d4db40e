// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "armcal/verification/check_trend.h"

namespace armcal::testing {

/// The judged history of a length error, one check a week; its limit is 0.05 mm, its centre line
/// comes from the first four.
inline CheckTrend weekly_checks(const std::vector<double>& values_mm) {
  CheckTrend trend;
  trend.name = "length_error";
  trend.limit_mm = 0.05;
  trend.is_signed = true;
  trend.baseline = 4;
  for (std::size_t i = 0; i < values_mm.size(); ++i) {
    const auto number = static_cast<std::int64_t>(i);
    trend.points.push_back({number + 1, 1767571200 + 604800 * number, values_mm[i]});
  }
  return judged(trend);
}

}  // namespace armcal::testing
