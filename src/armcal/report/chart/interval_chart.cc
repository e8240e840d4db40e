// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/interval_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/legend.h"
#include "armcal/report/chart/scale.h"

namespace armcal {
namespace {

constexpr double kIntervalWidth = 480.0;
constexpr double kIntervalRow = 20.0;
constexpr double kIntervalMostNames = 150.0, kMostTexts = 130.0;
constexpr double kIntervalAxis = 46.0;  // ticks and label below a group
constexpr double kIntervalMark = 4.0;

double half_width_of(const IntervalRow& row) {
  return std::isfinite(row.half_width) ? std::abs(row.half_width) : 0.0;
}

ChartRange range_of_rows(const IntervalGroup& group) {
  std::optional<ChartRange> range = ChartRange{0.0, 0.0};
  for (const IntervalRow& row : group.rows) {
    if (!std::isfinite(row.value)) continue;
    const double half = half_width_of(row);
    range = united(range, ChartRange{row.value - half, row.value + half});
  }
  return axis_range({}, range);
}

void draw_mark(SvgDrawing& drawing, double x, double y, bool is_held) {
  const std::string colour = is_held ? "currentColor" : series_colour(0);
  drawing.circle(x, y, kIntervalMark,
                 fmt::format("class=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"",
                             is_held ? "held" : "s0", is_held ? kPaperColour : colour, colour));
}

class IntervalPicture {
 public:
  explicit IntervalPicture(const IntervalChart& chart)
      : chart_(chart), legend_(entries(), 4.0, kIntervalWidth - 4.0) {
    double names = 0.0;
    double texts = 0.0;
    for (const IntervalGroup& group : chart.groups) {
      for (const IntervalRow& row : group.rows) {
        names = std::max(names, text_width(row.name, kTextSize));
        texts = std::max(texts, text_width(row.text, 12.0));
      }
    }
    left_ = std::min(names, kIntervalMostNames) + 14.0;
    right_ = kIntervalWidth - (texts > 0.0 ? std::min(texts, kMostTexts) + 12.0 : 10.0);
  }

  [[nodiscard]] std::string svg() const {
    const double head = ChartLegend::kRowHeight * legend_.rows() + 10.0;
    double height = head;
    for (const IntervalGroup& group : chart_.groups) height += height_of(group);
    SvgDrawing drawing(kIntervalWidth, height);
    legend_.draw(drawing, 16.0);
    double top = head;
    for (const IntervalGroup& group : chart_.groups) {
      if (!group.rows.empty()) draw(drawing, group, top);
      top += height_of(group);
    }
    return drawing.finished(chart_.title, chart_.text, "intervals");
  }

 private:
  [[nodiscard]] static double height_of(const IntervalGroup& group) {
    return group.rows.empty()
               ? 0.0
               : kIntervalRow * static_cast<double>(group.rows.size()) + kIntervalAxis + 8.0;
  }

  [[nodiscard]] std::vector<LegendEntry> entries() const {
    std::vector<LegendEntry> entries;
    for (const bool is_held : {false, true}) {
      const std::string& name = is_held ? chart_.held : chart_.estimated;
      const bool is_there =
          std::any_of(chart_.groups.begin(), chart_.groups.end(), [&](const IntervalGroup& group) {
            return std::any_of(group.rows.begin(), group.rows.end(),
                               [&](const IntervalRow& row) { return row.is_held == is_held; });
          });
      if (!is_there || name.empty()) continue;
      entries.push_back({name, [is_held](SvgDrawing& drawing, double x, double y) {
                           draw_mark(drawing, x, y, is_held);
                         }});
    }
    return entries;
  }

  void draw(SvgDrawing& drawing, const IntervalGroup& group, double top) const {
    const double bottom = top + kIntervalRow * static_cast<double>(group.rows.size());
    const ChartScale x(AxisScale::linear, range_of_rows(group), left_, right_);
    draw_axis(drawing, group, x, top, bottom);
    double middle = top + 0.5 * kIntervalRow;
    for (const IntervalRow& row : group.rows) {
      draw(drawing, row, x, middle);
      middle += kIntervalRow;
    }
  }

  void draw_axis(SvgDrawing& drawing, const IntervalGroup& group, const ChartScale& x, double top,
                 double bottom) const {
    std::string grid;
    const int ticks = std::max(2, static_cast<int>((right_ - left_) / 46.0));
    for (const ChartTick& tick : x.ticks_below(ticks, kTextSize)) {
      const double at = x.at(tick.value);
      grid += fmt::format("M{}V{}", point(at, top), coordinate(bottom));
      const double half = 0.5 * text_width(tick.text, kTextSize);
      const double middle = std::min(at, kIntervalWidth - half);
      drawing.text(middle, bottom + 16.0, tick.text,
                   {.style = "tick", .anchor = TextAnchor::middle});
    }
    drawing.path(grid, "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".13\"");
    drawing.line(x.at(0.0), top, x.at(0.0), bottom,
                 "class=\"axis\" stroke=\"currentColor\" stroke-opacity=\".7\"");
    drawing.text(0.5 * (left_ + right_), bottom + 34.0, group.label,
                 {.anchor = TextAnchor::middle, .most_width = right_ - left_});
  }

  void draw(SvgDrawing& drawing, const IntervalRow& row, const ChartScale& x, double middle) const {
    drawing.text(left_ - 8.0, middle + 4.5, row.name,
                 {.anchor = TextAnchor::end, .most_width = left_ - 10.0});
    drawing.text(kIntervalWidth - 4.0, middle + 4.5, row.text,
                 {.style = "tick",
                  .anchor = TextAnchor::end,
                  .size = 12.0,
                  .most_width = kIntervalWidth - right_ - 8.0});
    if (!std::isfinite(row.value)) return;
    const double half = half_width_of(row);
    if (half > 0.0) {
      const bool is_strong = std::abs(row.value) > half;
      drawing.path(
          fmt::format("M{}v6M{}v6M{}H{}", point(x.at(row.value - half), middle - 3.0),
                      point(x.at(row.value + half), middle - 3.0),
                      point(x.at(row.value - half), middle), coordinate(x.at(row.value + half))),
          fmt::format("class=\"interval\" stroke=\"{}\" stroke-width=\"{}\"",
                      row.is_held ? "currentColor" : series_colour(0), is_strong ? "2.2" : "1.2"));
    }
    draw_mark(drawing, x.at(row.value), middle, row.is_held);
  }

  const IntervalChart& chart_;
  ChartLegend legend_;
  double left_ = 0.0, right_ = kIntervalWidth;
};

}  // namespace

Figure figure_of(const IntervalChart& chart) {
  const bool is_empty = std::all_of(chart.groups.begin(), chart.groups.end(),
                                    [](const IntervalGroup& group) { return group.rows.empty(); });
  return {.id = chart.id,
          .title = chart.title,
          .text = chart.text,
          .svg = is_empty ? nothing_drawn(chart.title, chart.text, chart.nothing)
                          : IntervalPicture(chart).svg()};
}

}  // namespace armcal
