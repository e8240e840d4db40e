// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/report/chart/chart.h"

namespace armcal {

struct ChartRange {
  double low = 0.0;
  double high = 1.0;
};

/// Can a value stand on such an axis: is it finite, and positive on a logarithmic one?
[[nodiscard]] bool fits(double value, AxisScale scale);

/// From the least to the largest of the values that fit on the axis; nothing where none does.
[[nodiscard]] std::optional<ChartRange> range_of(std::span<const double> values, AxisScale scale);
[[nodiscard]] std::optional<ChartRange> united(const std::optional<ChartRange>& one,
                                               const std::optional<ChartRange>& other);

/// The range of an axis: that of the data with a little room, widened to the ends that the axis has
/// at least (without room where the data stay inside these). Never empty: a single value gets a
/// range about it, and a range that numbers of 10 digits cannot divide is widened.
[[nodiscard]] ChartRange axis_range(const ChartAxis& axis, const std::optional<ChartRange>& data);

/// A mark on an axis.
struct ChartTick {
  double value = 0.0;
  std::string text;  ///< empty: of a small one
};

/// Values to places in a drawing.
class ChartScale {
 public:
  /// @param range  of positive length, positive where the scale is logarithmic
  /// @param from, to  where its ends are drawn
  ChartScale(AxisScale kind, ChartRange range, double from, double to);

  /// Where a value is drawn; what is beyond an end, at that end.
  [[nodiscard]] double at(double value) const;
  [[nodiscard]] const ChartRange& range() const { return range_; }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }

  /// About so many marks with numbers, at multiples of 1, 2 or 5 times a power of ten; on a
  /// logarithmic scale at decades, and where these are few at 2 and 5 times them.
  [[nodiscard]] std::vector<ChartTick> ticks(int about) const;
  /// The same on an axis from left to right: fewer where texts of this size would meet.
  [[nodiscard]] std::vector<ChartTick> ticks_below(int about, double text_size) const;

 private:
  [[nodiscard]] std::vector<ChartTick> linear_ticks(int about) const;
  [[nodiscard]] std::vector<ChartTick> decade_ticks(int about, bool names_between) const;

  AxisScale kind_;
  ChartRange range_;
  double from_;
  double to_;
};

/// The least of 1, 2 and 5 times a power of ten that is not below a positive value.
[[nodiscard]] double nice_step(double at_least);

/// "-2.5" with a true minus sign and this many decimals; never minus nought.
[[nodiscard]] std::string signed_text(double value, int decimals);
/// 10^-3 as "0.001", 10^-6 as "10⁻⁶", with a factor before it as "2×10⁻⁶".
[[nodiscard]] std::string power_text(int factor, int exponent);

}  // namespace armcal
