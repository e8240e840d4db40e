// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/repeatability.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "armcal/numerics/distributions.h"

namespace armcal {
namespace {

constexpr int kLeastFreedom = 40;
constexpr std::size_t kLeastReadings = 3;
constexpr double kTooWide = 1e-4;
constexpr double kTooDifferent = 1e-3;

struct Spread {
  int freedom = 0;
  double variance = 0.0;  // of one point along the line between the ends, mm^2
};

std::optional<Spread> spread_of(const Reduction& reduction) {
  if (!reduction.end_a || !reduction.end_b) return std::nullopt;
  const EndStatistics& a = *reduction.end_a;
  const EndStatistics& b = *reduction.end_b;
  const int freedom = a.count + b.count - 2;
  if (freedom < 1) return std::nullopt;
  return Spread{freedom,
                ((a.count - 1) * a.s_mm * a.s_mm + (b.count - 1) * b.s_mm * b.s_mm) / freedom};
}

bool is_too_wide(const Spread& spread, double shared) {
  return chi_squared_survival(spread.freedom * spread.variance / shared, spread.freedom) < kTooWide;
}

// Bartlett's test: do the spreads differ by more than chance?
bool differ(const std::vector<Spread>& spreads) {
  double freedom = 0.0;
  double squares = 0.0;
  double logarithms = 0.0;
  double inverses = 0.0;
  for (const Spread& each : spreads) {
    freedom += each.freedom;
    squares += each.freedom * each.variance;
    logarithms += each.freedom * std::log(each.variance);
    inverses += 1.0 / each.freedom;
  }
  const auto others = static_cast<double>(spreads.size()) - 1.0;
  const double correction = 1.0 + (inverses - 1.0 / freedom) / (3.0 * others);
  const double statistic = (freedom * std::log(squares / freedom) - logarithms) / correction;
  return chi_squared_survival(statistic, others) < kTooDifferent;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

}  // namespace

void share_repeatability(std::vector<Reduction>& reductions) {
  std::vector<Spread> spreads;
  std::vector<double> variances;
  for (const Reduction& reduction : reductions) {
    const auto spread = spread_of(reduction);
    if (!spread || !(spread->variance > 0.0)) continue;
    spreads.push_back(*spread);
    variances.push_back(spread->variance * spread->freedom /
                        chi_squared_quantile(0.5, spread->freedom));
  }
  if (spreads.size() < kLeastReadings) return;
  const double shared = median(std::move(variances));
  std::erase_if(spreads, [&](const Spread& each) { return is_too_wide(each, shared); });
  int freedom = 0;
  for (const Spread& each : spreads) freedom += each.freedom;
  if (freedom < kLeastFreedom || spreads.size() < kLeastReadings || differ(spreads)) return;
  for (Reduction& reduction : reductions) {
    const auto spread = spread_of(reduction);
    if (!spread || is_too_wide(*spread, shared)) continue;
    reduction.u_type_a =
        std::sqrt(shared * (1.0 / reduction.end_a->count + 1.0 / reduction.end_b->count));
  }
}

}  // namespace armcal
