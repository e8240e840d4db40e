// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/legend.h"

#include <algorithm>

namespace armcal {
namespace {

constexpr double kSample = 22.0;
constexpr double kGap = 6.0;       // between sample and name
constexpr double kBetween = 18.0;  // entries

}  // namespace

ChartLegend::ChartLegend(std::vector<LegendEntry> entries, double left, double right, double taken)
    : entries_(std::move(entries)), most_width_(right - left - kSample - kGap) {
  const auto width_of = [&](const LegendEntry& entry) {
    return kSample + kGap + std::min(most_width_, text_width(entry.name, kTextSize));
  };
  double together = -kBetween;
  for (const LegendEntry& entry : entries_) together += width_of(entry) + kBetween;
  const bool is_one_row = left + taken + together <= right;
  double x = is_one_row && taken > 0.0 ? right - together : left;
  int row = is_one_row || taken <= 0.0 ? 0 : 1;
  for (const LegendEntry& entry : entries_) {
    const double width = width_of(entry);
    if (x > left && x + width > right + 0.01) {
      ++row;
      x = left;
    }
    places_.push_back({x, row});
    x += width + kBetween;
  }
  rows_ = entries_.empty() ? 0 : row + 1;
}

void ChartLegend::draw(SvgDrawing& drawing, double y) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const double base = y + kRowHeight * places_[i].row;
    entries_[i].sample(drawing, places_[i].x + 0.5 * kSample, base - 4.5);
    drawing.text(places_[i].x + kSample + kGap, base, entries_[i].name,
                 {.style = "legend", .most_width = most_width_});
  }
}

}  // namespace armcal
