// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "armcal/verification/check_trend.h"

namespace armcal {

/// Is a limit drawn with a history? One that is far from all values would press them together: it
/// is, where it lies among them or within 12 sigma of the centre line, or there is none yet.
[[nodiscard]] bool is_on_chart(double limit_mm, std::span<const double> values_mm,
                               const std::optional<ControlLimits>& limits);

/// A trend for a terminal: a line for each of the last checks, with its value and a mark where that
/// lies between the control limits, below it the rules that these checks break, and the drift.
[[nodiscard]] std::string trend_chart(const CheckTrend& trend, std::size_t last_checks = 20);

/// "+0.0012 mm in 30 days (u 0.0004)"
[[nodiscard]] std::string drift_text(const Drift& drift);

}  // namespace armcal
