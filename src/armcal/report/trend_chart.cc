// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/trend_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/utc_time.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

constexpr int kTrendWidth = 41;

// Where values lie on a line of characters.
class Scale {
 public:
  void include(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  [[nodiscard]] std::size_t at(double value) const {
    const double share = high_ > low_ ? (value - low_) / (high_ - low_) : 0.5;
    return static_cast<std::size_t>(std::lround(share * (kTrendWidth - 1)));
  }
  [[nodiscard]] bool holds(double value) const { return value >= low_ && value <= high_; }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

Scale scale_of(const CheckTrend& trend, std::size_t first) {
  Scale scale;
  for (std::size_t i = first; i < trend.points.size(); ++i) scale.include(trend.points[i].value_mm);
  if (trend.limits) {
    scale.include(trend.limits->lower());
    scale.include(trend.limits->upper());
  }
  if (!trend.limit_mm) return scale;
  std::vector<double> values_mm;
  for (std::size_t i = first; i < trend.points.size(); ++i) {
    values_mm.push_back(trend.points[i].value_mm);
  }
  for (const double limit_mm : {*trend.limit_mm, -*trend.limit_mm}) {
    if (limit_mm < 0.0 && !trend.is_signed) continue;
    if (is_on_chart(limit_mm, values_mm, trend.limits)) scale.include(limit_mm);
  }
  return scale;
}

std::string line_of(const CheckTrend& trend, const Scale& scale, double value_mm, bool breaks) {
  std::string line(kTrendWidth, ' ');
  if (trend.limits) {
    line[scale.at(trend.limits->lower())] = ':';
    line[scale.at(trend.limits->upper())] = ':';
    line[scale.at(trend.limits->center)] = '|';
  }
  if (trend.limit_mm) {
    if (scale.holds(*trend.limit_mm)) line[scale.at(*trend.limit_mm)] = ']';
    if (trend.is_signed && scale.holds(-*trend.limit_mm)) line[scale.at(-*trend.limit_mm)] = '[';
  }
  line[scale.at(value_mm)] = breaks ? '#' : '*';
  return line;
}

std::vector<RuleViolation> violations_at(const CheckTrend& trend, std::size_t point) {
  std::vector<RuleViolation> found;
  for (const RuleViolation& each : trend.violations) {
    if (each.at == point) found.push_back(each);
  }
  return found;
}

std::string legend(const CheckTrend& trend) {
  if (!trend.limits) {
    return fmt::format("  a centre line comes with {} checks; {} so far\n", trend.baseline,
                       trend.points.size());
  }
  std::string text =
      fmt::format("  | centre {}, : 3 sigma (sigma {}, both of the first {} checks)",
                  fixed(trend.limits->center, 4), fixed(trend.limits->sigma, 4), trend.baseline);
  if (trend.limit_mm) text += fmt::format(", ] limit {}", fixed(*trend.limit_mm, 4));
  if (!trend.violations.empty()) text += ", # breaks a rule";
  return text + "\n";
}

std::string drift_line(const CheckTrend& trend) {
  if (!trend.drift) return "";
  if (!trend.drift->is_significant) {
    return fmt::format("  no drift beyond chance: {}\n", drift_text(*trend.drift));
  }
  std::string text = fmt::format("  drift: {}", drift_text(*trend.drift));
  if (const auto days = trend.days_to_limit())
    text += fmt::format(", at the limit in {} days", fixed(*days, 0));
  return text + "\n";
}

}  // namespace

bool is_on_chart(double limit_mm, std::span<const double> values_mm,
                 const std::optional<ControlLimits>& limits) {
  constexpr double kNear_sigma = 12.0;
  if (!limits || std::abs(limit_mm - limits->center) < kNear_sigma * limits->sigma) return true;
  const auto [low, high] = std::minmax_element(values_mm.begin(), values_mm.end());
  return low != values_mm.end() && limit_mm >= *low && limit_mm <= *high;
}

std::string drift_text(const Drift& drift) {
  return fmt::format("{}{} mm in 30 days (u {})", drift.mm_per_day < 0.0 ? "" : "+",
                     fixed(kMonth_days * drift.mm_per_day, 4),
                     fixed(kMonth_days * drift.u_mm_per_day, 4));
}

std::string trend_chart(const CheckTrend& trend, std::size_t last_checks) {
  const std::size_t first =
      trend.points.size() > last_checks ? trend.points.size() - last_checks : 0;
  const Scale scale = scale_of(trend, first);
  TextTable table({{"check"}, {"date", Align::left}, {"mm"}, {"", Align::left}});
  std::string broken;
  for (std::size_t i = first; i < trend.points.size(); ++i) {
    const TrendPoint& point = trend.points[i];
    const auto violations = violations_at(trend, i);
    table.add_row({fmt::format("{}", point.check), utc_text(point.time_s).substr(0, 10),
                   fixed(point.value_mm, 4),
                   line_of(trend, scale, point.value_mm, !violations.empty())});
    for (const RuleViolation& each : violations) {
      broken += fmt::format("  check {}: {}\n", point.check, explain(each));
    }
  }
  return table.text() + legend(trend) + broken + drift_line(trend);
}

}  // namespace armcal
