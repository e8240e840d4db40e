// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/length_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace armcal::iso10360_12 {
namespace {

constexpr std::size_t kLengths = 5;
constexpr std::size_t kPositions = 7;
constexpr int kRepeats = 3;
constexpr double kLongestShareOfReach = 0.66;
constexpr double kSameLength_mm = 1.0;

// How often a length was measured at each position.
struct LengthSeries {
  double length_mm = 0.0;  // of the first one
  std::map<std::string, int> repeats_at;
};

std::vector<LengthSeries> series_of(std::span<const MeasuredLength> lengths) {
  std::vector<MeasuredLength> sorted(lengths.begin(), lengths.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& one, const auto& other) {
    return one.calibrated_mm < other.calibrated_mm;
  });
  std::vector<LengthSeries> series;
  double before_mm = 0.0;
  for (const MeasuredLength& length : sorted) {
    if (series.empty() || length.calibrated_mm - before_mm > kSameLength_mm) {
      series.push_back({length.calibrated_mm, {}});
    }
    ++series.back().repeats_at[length.position];
    before_mm = length.calibrated_mm;
  }
  return series;
}

void add_missing_of(const LengthSeries& series, std::vector<std::string>& missing) {
  const std::string length = fmt::format("length {:.6g} mm", series.length_mm);
  if (const std::size_t positions = series.repeats_at.size(); positions < kPositions) {
    missing.push_back(fmt::format("{} at {} position{}, {} are asked for", length, positions,
                                  positions == 1 ? "" : "s", kPositions));
  }
  for (const auto& [position, repeats] : series.repeats_at) {
    if (repeats >= kRepeats) continue;
    missing.push_back(fmt::format("{} measured {} time{} at position {}, {} are asked for", length,
                                  repeats, repeats == 1 ? "" : "s", position, kRepeats));
  }
}

}  // namespace

std::vector<std::string> missing_lengths(std::span<const MeasuredLength> lengths,
                                         std::optional<double> reach_mm) {
  std::vector<std::string> missing;
  const std::vector<LengthSeries> series = series_of(lengths);
  if (series.size() < kLengths) {
    missing.push_back(fmt::format("{} calibrated length{}, {} are asked for", series.size(),
                                  series.size() == 1 ? "" : "s", kLengths));
  }
  for (const LengthSeries& each : series) add_missing_of(each, missing);
  if (reach_mm && !series.empty()) {
    const double share = series.back().length_mm / *reach_mm;
    if (share < kLongestShareOfReach) {
      missing.push_back(fmt::format(
          "the longest length of {:.6g} mm is {:.0f} % of the reach of {:.6g} mm, {:.0f} % are "
          "asked for",
          series.back().length_mm, 100.0 * share, *reach_mm, 100.0 * kLongestShareOfReach));
    }
  }
  return missing;
}

}  // namespace armcal::iso10360_12
