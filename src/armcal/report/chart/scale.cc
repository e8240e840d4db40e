// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/svg.h"
#include "armcal/report/number_format.h"

namespace armcal {
namespace {

constexpr double kRoom = 0.04;         // of the length of an axis, beyond the data
constexpr double kFewestParts = 1e-9;  // of its magnitude that a range is long
constexpr double kBetweenTexts = 5.0;
constexpr double kLargest = 1e300;  // differences of what is drawn are finite
constexpr double kSmallest = 1e-300;
constexpr double kFewer = 0.8;      // of a step: a few ticks more rather than half as many
constexpr int kMostPerName = 5;     // decades that have a mark each, if only one of so many a name
constexpr int kFewestNamed = 3;     // ticks of a logarithmic axis
constexpr double kRounding = 1e-9;  // of a step

constexpr const char* kMinus = "\u2212";
constexpr const char* kTimesTen = "\u00d710";

std::string superscript(int exponent) {
  static constexpr const char* kDigits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                            "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "\u207b" : "";
  for (const char c : fmt::format("{}", std::abs(exponent))) text += kDigits[c - '0'];
  return text;
}

int exponent_of(double positive) {
  return static_cast<int>(std::floor(std::log10(positive) + kRounding));
}

// The quotient of the ends of a range may be beyond all numbers.
double decades_of(const ChartRange& range) {
  return std::log10(range.high) - std::log10(range.low);
}

ChartRange not_empty(ChartRange range, AxisScale scale) {
  if (scale == AxisScale::logarithmic) {
    range.low = std::clamp(range.low, kSmallest, kLargest);
    range.high = std::clamp(range.high, kSmallest, kLargest);
    const bool is_narrow = range.high / range.low < 1.0 + 1e-6;
    return is_narrow ? ChartRange{range.low / 3.0, range.high * 3.0} : range;
  }
  range.low = std::clamp(range.low, -kLargest, kLargest);
  range.high = std::clamp(range.high, -kLargest, kLargest);
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  if (magnitude < kSmallest) return {-1.0, 1.0};
  if (range.high == range.low) return {range.low - 0.1 * magnitude, range.high + 0.1 * magnitude};
  const double missing = kFewestParts * magnitude - (range.high - range.low);
  if (missing > 0.0) return {range.low - 0.5 * missing, range.high + 0.5 * missing};
  return range;
}

// One text for all ticks of an axis: as many decimals as the step needs, powers where these are
// many.
std::string tick_text(double value, double step, double largest) {
  if (value == 0.0) return "0";
  const int step_exponent = exponent_of(step);
  const int exponent = exponent_of(largest);
  if (exponent < 6 && step_exponent > -6) {
    return signed_text(value, std::max(0, -step_exponent));
  }
  const double mantissa = value / std::pow(10.0, exponent);
  return fmt::format("{}{}{}", signed_text(mantissa, std::clamp(exponent - step_exponent, 0, 12)),
                     kTimesTen, superscript(exponent));
}

}  // namespace

bool fits(double value, AxisScale scale) {
  return std::isfinite(value) && (scale == AxisScale::linear || value > 0.0);
}

std::optional<ChartRange> range_of(std::span<const double> values, AxisScale scale) {
  std::optional<ChartRange> range;
  for (const double value : values) {
    if (fits(value, scale)) range = united(range, ChartRange{value, value});
  }
  return range;
}

std::optional<ChartRange> united(const std::optional<ChartRange>& one,
                                 const std::optional<ChartRange>& other) {
  if (!one) return other;
  if (!other) return one;
  return ChartRange{std::min(one->low, other->low), std::max(one->high, other->high)};
}

ChartRange axis_range(const ChartAxis& axis, const std::optional<ChartRange>& data) {
  const bool is_log = axis.scale == AxisScale::logarithmic;
  // An end that is not wanted is one that changes nothing.
  const double low = axis.low && fits(*axis.low, axis.scale) ? *axis.low : HUGE_VAL;
  const double high = axis.high && fits(*axis.high, axis.scale) ? *axis.high : -HUGE_VAL;
  ChartRange range{std::min(low, high), std::max(low, high)};
  if (low == HUGE_VAL || high == -HUGE_VAL) {
    const double some = low < HUGE_VAL ? low : high;
    range = some > -HUGE_VAL ? ChartRange{some, some}
                             : ChartRange{is_log ? 1.0 : 0.0, is_log ? 10.0 : 1.0};
  }
  if (data) range = *data;
  const bool low_holds = low <= range.low;
  const bool high_holds = high >= range.high;
  range.low = std::min(range.low, low);
  range.high = std::max(range.high, high);
  range = not_empty(range, axis.scale);
  const double room = kRoom * (is_log ? decades_of(range) : range.high - range.low);
  if (!low_holds) range.low = is_log ? range.low / std::pow(10.0, room) : range.low - room;
  if (!high_holds) range.high = is_log ? range.high * std::pow(10.0, room) : range.high + room;
  return not_empty(range, axis.scale);
}

ChartScale::ChartScale(AxisScale kind, ChartRange range, double from, double to)
    : kind_(kind), range_(not_empty(range, kind)), from_(from), to_(to) {}

double ChartScale::at(double value) const {
  const double inside = std::clamp(value, range_.low, range_.high);
  const double part = kind_ == AxisScale::logarithmic
                          ? decades_of({range_.low, inside}) / decades_of(range_)
                          : (inside - range_.low) / (range_.high - range_.low);
  return from_ + std::clamp(part, 0.0, 1.0) * (to_ - from_);
}

std::vector<ChartTick> ChartScale::ticks(int about) const {
  if (kind_ == AxisScale::linear) return linear_ticks(about);
  const bool have_room = 3.0 * decades_of(range_) <= about;
  for (const bool names_between : {have_room, true}) {
    std::vector<ChartTick> ticks = decade_ticks(about, names_between);
    const auto named = std::count_if(ticks.begin(), ticks.end(),
                                     [](const ChartTick& tick) { return !tick.text.empty(); });
    if (named >= kFewestNamed) return ticks;
  }
  return linear_ticks(about);
}

std::vector<ChartTick> ChartScale::ticks_below(int about, double text_size) const {
  for (;; --about) {
    std::vector<ChartTick> fewer = ticks(about);
    double free_from = -HUGE_VAL;
    bool is_free = true;
    for (const ChartTick& tick : fewer) {
      if (tick.text.empty()) continue;
      const double half = 0.5 * text_width(tick.text, text_size);
      is_free = is_free && at(tick.value) - half >= free_from;
      free_from = at(tick.value) + half + kBetweenTexts;
    }
    if (is_free || about <= 1) return fewer;
  }
}

std::vector<ChartTick> ChartScale::linear_ticks(int about) const {
  const double step = nice_step(kFewer * (range_.high - range_.low) / std::max(1, about));
  const double largest = std::max(std::abs(range_.low), std::abs(range_.high));
  const double first = std::ceil(range_.low / step - kRounding);
  const double last = std::floor(range_.high / step + kRounding);
  std::vector<ChartTick> ticks;
  for (double i = first; i <= last; ++i) {
    const double value = std::clamp(i * step, range_.low, range_.high);
    ticks.push_back({i == 0.0 ? 0.0 : value, tick_text(i == 0.0 ? 0.0 : i * step, step, largest)});
  }
  return ticks;
}

std::vector<ChartTick> ChartScale::decade_ticks(int about, bool names_between) const {
  const int first = exponent_of(range_.low);
  const int last = exponent_of(range_.high);
  const double decades = decades_of(range_);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(1, about))));
  std::vector<ChartTick> ticks;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (const int factor : {1, 2, 5}) {
      const double value = factor * std::pow(10.0, exponent);
      const bool is_inside =
          value >= range_.low * (1.0 - kRounding) && value <= range_.high * (1.0 + kRounding);
      const bool is_named = factor == 1 ? exponent % every == 0 : names_between;
      const bool has_room = factor == 1 ? every <= kMostPerName : every == 1;
      if (!is_inside || !(is_named || has_room)) continue;
      ticks.push_back({std::clamp(value, range_.low, range_.high),
                       is_named ? power_text(factor, exponent) : ""});
    }
  }
  return ticks;
}

double nice_step(double at_least) {
  const double power = std::pow(10.0, std::floor(std::log10(at_least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= at_least * (1.0 - kRounding)) return factor * power;
  }
  return 10.0 * power;
}

std::string signed_text(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.starts_with('-')) text.replace(0, 1, kMinus);
  return text;
}

std::string power_text(int factor, int exponent) {
  if (exponent >= -4 && exponent <= 4) {
    return fixed(factor * std::pow(10.0, exponent), std::max(0, -exponent));
  }
  const std::string power = fmt::format("10{}", superscript(exponent));
  return factor == 1 ? power : fmt::format("{}\u00d7{}", factor, power);
}

}  // namespace armcal
