// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/histogram.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/numerics/distributions.h"
#include "armcal/report/chart/scale.h"

namespace armcal {
namespace {

constexpr int kMostBins = 60;
constexpr double kLargest = 1e300;  // differences of values are finite
constexpr double kFarAway = 5.0;    // ranges of the middle half
constexpr std::size_t kBandPoints = 60;

std::vector<double> sorted_finite(std::span<const double> values) {
  std::vector<double> sorted;
  for (const double value : values) {
    if (std::abs(value) <= kLargest) sorted.push_back(value);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double quantile_of_sorted(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

// Quantile of the beta distribution (i, n + 1 - i), by that of F.
double order_statistic(double i, double n, double probability) {
  const double others = n + 1.0 - i;
  const double f = f_quantile(probability, 2.0 * i, 2.0 * others);
  return i * f / (i * f + others);
}

double blom(double i, double n) { return normal_quantile((i - 0.375) / (n + 0.25)); }

// Orders from 1 to n: all near the ends, where the band bends, and some between.
std::vector<double> some_orders(std::size_t n) {
  std::vector<double> orders;
  const double least = blom(1.0, static_cast<double>(n));
  for (std::size_t k = 0; k <= kBandPoints; ++k) {
    const double z = least * (1.0 - 2.0 * static_cast<double>(k) / kBandPoints);
    const double order = std::round(normal_cdf(z) * (static_cast<double>(n) + 0.25) + 0.375);
    const double inside = std::clamp(order, 1.0, static_cast<double>(n));
    if (orders.empty() || inside > orders.back()) orders.push_back(inside);
  }
  return orders;
}

bool lies_beyond(const HistogramBins& bins, double value) {
  return value < bins.edges.front() || value > bins.edges.back();
}

}  // namespace

HistogramBins histogram_bins(std::span<const double> values) {
  const std::vector<double> sorted = sorted_finite(values);
  if (sorted.empty()) return {};
  const double lower = quantile_of_sorted(sorted, 0.25);
  const double upper = quantile_of_sorted(sorted, 0.75);
  const double middle_half = upper - lower;
  double low = sorted.front();
  double high = sorted.back();
  if (middle_half > 0.0) {
    low = std::max(low, lower - kFarAway * middle_half);
    high = std::min(high, upper + kFarAway * middle_half);
  }
  // A single value, or values that are all but one: a bin that holds them.
  const double magnitude = std::max(std::abs(low), std::abs(high));
  const double least = std::max(1e-9 * magnitude, 1e-300);
  const double wanted = middle_half > 0.0
                            ? 2.0 * middle_half / std::cbrt(static_cast<double>(sorted.size()))
                            : (high - low) / 10.0;
  const double step = nice_step(std::max({wanted, (high - low) / (kMostBins - 2), least}));
  const double first = std::floor(low / step);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(high / step) - first));
  HistogramBins bins;
  for (std::size_t i = 0; i <= count; ++i) {
    bins.edges.push_back((first + static_cast<double>(i)) * step);
  }
  bins.counts.assign(count, 0.0);
  for (const double value : sorted) {
    const double bin = std::floor(value / step) - first;
    const double inside = std::clamp(bin, 0.0, static_cast<double>(count - 1));
    if (lies_beyond(bins, value)) ++bins.beyond;
    bins.counts[static_cast<std::size_t>(inside)] += 1.0;
  }
  return bins;
}

Chart with_histogram(Chart chart, const std::string& name, const std::string& density_name,
                     const HistogramBins& bins) {
  if (bins.counts.empty()) return chart;
  double total = 0.0;
  for (const double count : bins.counts) total += count;
  ChartSeries expected{.name = density_name, .mark = Mark::steps, .style = 1, .x = bins.edges};
  for (std::size_t i = 0; i < bins.counts.size(); ++i) {
    expected.y.push_back(total * (normal_cdf(bins.edges[i + 1]) - normal_cdf(bins.edges[i])));
  }
  expected.y.push_back(expected.y.back());  // where the last step ends
  chart.series.push_back(
      {.name = name, .mark = Mark::bars, .style = 0, .x = bins.edges, .y = bins.counts});
  chart.series.push_back(std::move(expected));
  return chart;
}

Chart with_normal_quantiles(Chart chart, const QuantilePlotNames& names,
                            std::span<const double> values) {
  const std::vector<double> sorted = sorted_finite(values);
  if (sorted.empty()) return chart;
  const auto n = static_cast<double>(sorted.size());
  const HistogramBins bins = histogram_bins(sorted);
  ChartSeries points{.name = names.points, .mark = Mark::dots, .style = 0};
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (lies_beyond(bins, sorted[k])) continue;
    points.x.push_back(blom(static_cast<double>(k + 1), n));
    points.y.push_back(sorted[k]);
  }
  const double end = std::max(1.0, -blom(1.0, n));
  ChartSeries diagonal{
      .name = names.diagonal, .mark = Mark::line, .style = 1, .x = {-end, end}, .y = {-end, end}};
  ChartSeries low{.name = names.band, .mark = Mark::line, .style = 2};
  ChartSeries high{.name = "", .mark = Mark::line, .style = 2};
  for (const double i : some_orders(sorted.size())) {
    low.x.push_back(blom(i, n));
    high.x.push_back(blom(i, n));
    low.y.push_back(normal_quantile(order_statistic(i, n, 0.025)));
    high.y.push_back(normal_quantile(order_statistic(i, n, 0.975)));
  }
  for (ChartSeries* series : {&points, &diagonal, &low, &high}) {
    chart.series.push_back(std::move(*series));
  }
  return chart;
}

}  // namespace armcal
