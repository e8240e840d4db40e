// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/repeatability.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "armcal/numerics/distributions.h"

namespace armcal {
namespace {

constexpr int kLeastFreedom = 20;
constexpr std::size_t kLeastReadings = 3;
constexpr double kTooWide = 1e-4;

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

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

}  // namespace

void share_repeatability(std::vector<Reduction>& reductions) {
  int freedom = 0;
  std::vector<double> variances;
  for (const Reduction& reduction : reductions) {
    const auto spread = spread_of(reduction);
    if (!spread) continue;
    freedom += spread->freedom;
    variances.push_back(spread->variance * spread->freedom /
                        chi_squared_quantile(0.5, spread->freedom));
  }
  if (freedom < kLeastFreedom || variances.size() < kLeastReadings) return;
  const double shared = median(std::move(variances));
  if (!(shared > 0.0)) return;
  for (Reduction& reduction : reductions) {
    const auto spread = spread_of(reduction);
    if (!spread) continue;
    const double chi_squared = spread->freedom * spread->variance / shared;
    if (chi_squared_survival(chi_squared, spread->freedom) < kTooWide) continue;
    reduction.u_type_a =
        std::sqrt(shared * (1.0 / reduction.end_a->count + 1.0 / reduction.end_b->count));
  }
}

}  // namespace armcal
