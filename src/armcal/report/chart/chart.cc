// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/legend.h"
#include "armcal/report/chart/live_chart.h"
#include "armcal/report/chart/marks.h"
#include "armcal/report/chart/quiet_place.h"
#include "armcal/report/chart/scale.h"

namespace armcal {
namespace {

constexpr double kChartWidth = 480.0, kChartHeight = 300.0;
constexpr double kWideWidth = 980.0, kWideHeight = 340.0;
constexpr double kLeastEqualHeight = 240.0, kMostEqualHeight = 520.0;  // of equal scales
constexpr double kRight = 14.0;                                        // margin
constexpr double kBelow = 42.0;     // of tick texts and the label of x
constexpr double kTitleRow = 20.0;  // of the label of y
constexpr double kPerTickX = 56.0;  // way between ticks, about
constexpr double kPerTickY = 42.0;

struct Ranges {
  ChartRange x, y;
};

bool has_place(const Chart& chart, double x, double y) {
  return fits(x, chart.x.scale) && fits(y, chart.y.scale);
}

std::size_t count_of(const ChartSeries& series) {
  const std::size_t columns =
      series.mark == Mark::bars && !series.x.empty() ? series.x.size() - 1 : series.x.size();
  return std::min(columns, series.y.size());
}

// Pieces of a series without gaps, in the values of the axes. Bars have a point at each edge.
std::vector<std::vector<DrawnPoint>> pieces_of(const Chart& chart, const ChartSeries& series) {
  std::vector<std::vector<DrawnPoint>> pieces(1);
  const std::size_t count = count_of(series);
  for (std::size_t i = 0; i < count; ++i) {
    if (!has_place(chart, series.x[i], series.y[i])) {
      if (!pieces.back().empty()) pieces.emplace_back();
      continue;
    }
    auto& piece = pieces.back();
    if (series.mark == Mark::steps && !piece.empty()) {
      piece.push_back({series.x[i], piece.back().y});
    }
    piece.push_back({series.x[i], series.y[i]});
    const bool is_bar = series.mark == Mark::bars && fits(series.x[i + 1], chart.x.scale);
    if (is_bar) piece.push_back({series.x[i + 1], series.y[i]});
  }
  if (pieces.back().empty()) pieces.pop_back();
  return pieces;
}

bool is_drawn(const Chart& chart, const ChartLine& line) {
  return fits(line.at, line.is_vertical ? chart.x.scale : chart.y.scale);
}

bool has_data(const Chart& chart) {
  return std::any_of(chart.series.begin(), chart.series.end(),
                     [&](const ChartSeries& series) { return !pieces_of(chart, series).empty(); });
}

Ranges ranges_of(const Chart& chart) {
  std::optional<ChartRange> x, y;
  for (const ChartSeries& series : chart.series) {
    for (const auto& piece : pieces_of(chart, series)) {
      for (const DrawnPoint& at : piece) {
        x = united(x, ChartRange{at.x, at.x});
        y = united(y, ChartRange{at.y, at.y});
      }
    }
  }
  for (const ChartLine& line : chart.lines) {
    if (!is_drawn(chart, line)) continue;
    auto& range = line.is_vertical ? x : y;
    range = united(range, ChartRange{line.at, line.at});
  }
  Chart with_ground = chart;
  for (const ChartSeries& series : chart.series) {
    // Bars stand on zero.
    if (series.mark == Mark::bars && !chart.y.low) with_ground.y.low = 0.0;
  }
  return {axis_range(chart.x, x), axis_range(with_ground.y, y)};
}

// One millimetre as long either way: the axis with the more room gets the longer range.
void make_equal(Ranges& ranges, double width, double height) {
  const double x_span = ranges.x.high - ranges.x.low;
  const double y_span = ranges.y.high - ranges.y.low;
  const double per_unit = std::min(width / x_span, height / y_span);
  const double more_x = width / per_unit - x_span;
  const double more_y = height / per_unit - y_span;
  ranges.x = {ranges.x.low - 0.5 * more_x, ranges.x.high + 0.5 * more_x};
  ranges.y = {ranges.y.low - 0.5 * more_y, ranges.y.high + 0.5 * more_y};
}

std::vector<LegendEntry> legend_of(const Chart& chart) {
  std::vector<LegendEntry> entries;
  for (const ChartSeries& series : chart.series) {
    if (series.name.empty()) continue;
    const int style = series.style;
    if (series.mark == Mark::dots) {
      entries.push_back({series.name, [style](SvgDrawing& drawing, double x, double y) {
                           const DrawnPoint at[] = {{x, y}};
                           drawing.path(shapes_path(style, at, 4.0), shape_attributes(style, 4.0));
                         }});
    } else if (series.mark == Mark::bars) {
      entries.push_back({series.name, [style](SvgDrawing& drawing, double x, double y) {
                           drawing.rectangle(x - 7, y - 5, 14, 10, bar_attributes(style));
                         }});
    } else {
      entries.push_back({series.name, [style](SvgDrawing& drawing, double x, double y) {
                           drawing.line(x - 11, y, x + 11, y, line_attributes(style));
                         }});
    }
  }
  return entries;
}

// The chart once its ranges are known.
class ChartPicture {
 public:
  explicit ChartPicture(const Chart& chart)
      : chart_(chart),
        ranges_(ranges_of(chart)),
        width_(chart.is_wide ? kWideWidth : kChartWidth),
        left_(left_margin()),
        legend_(legend_of(chart), 4.0, width_ - kRight, label_width()),
        top_(top_margin()),
        height_(chart.is_wide ? kWideHeight : kChartHeight) {
    if (chart.equal_scales) fit_equal();
  }

  [[nodiscard]] std::string svg() {
    SvgDrawing drawing(width_, height_);
    const ChartScale x(chart_.x.scale, ranges_.x, left_, width_ - kRight);
    const ChartScale y(chart_.y.scale, ranges_.y, height_ - kBelow, top_);
    draw_frame(drawing, x, y);
    for (const ChartSeries& series : chart_.series) draw(drawing, series, x, y);
    for (const ChartLine& line : chart_.lines) draw(drawing, line, x, y);
    for (const ChartLine& line : chart_.lines) label(drawing, line, x, y);
    for (const ChartSeries& series : chart_.series) tag(drawing, series, x, y);
    return drawing.finished(chart_.title, chart_.text, chart_.is_wide ? "wide" : "");
  }

 private:
  [[nodiscard]] double left_margin() const {
    // Which ticks there are depends little on the height.
    const double length = (chart_.is_wide ? kWideHeight : kChartHeight) - kBelow - 2.0 * kTitleRow;
    const ChartScale y(chart_.y.scale, ranges_.y, 0.0, length);
    double widest = 0.0;
    for (const ChartTick& tick : y.ticks(static_cast<int>(length / kPerTickY))) {
      widest = std::max(widest, text_width(tick.text, kTextSize));
    }
    return std::min(widest + 14.0, 0.4 * width_);
  }

  [[nodiscard]] double label_width() const {
    return chart_.y.label.empty() ? 0.0 : text_width(chart_.y.label, kTextSize) + 18.0;
  }

  [[nodiscard]] double top_margin() const {
    const int rows = std::max(legend_.rows(), chart_.y.label.empty() ? 0 : 1);
    return 8.0 + ChartLegend::kRowHeight * rows + (rows > 0 ? 6.0 : 0.0);
  }

  void fit_equal() {
    if (chart_.x.scale != AxisScale::linear || chart_.y.scale != AxisScale::linear) return;
    const double plot_width = width_ - kRight - left_;
    const double wanted =
        plot_width * (ranges_.y.high - ranges_.y.low) / (ranges_.x.high - ranges_.x.low);
    const double least = kLeastEqualHeight - top_ - kBelow;
    const double most = kMostEqualHeight - top_ - kBelow;
    const double plot_height = std::clamp(wanted, least, most);
    make_equal(ranges_, plot_width, plot_height);
    height_ = top_ + kBelow + plot_height;
  }

  void draw_frame(SvgDrawing& drawing, const ChartScale& x, const ChartScale& y) const {
    const double bottom = y.from();
    std::string grid;
    std::string marks;
    for (const ChartTick& tick : y.ticks(ticks_along(y, kPerTickY))) {
      const double at = y.at(tick.value);
      grid += fmt::format("M{}H{}", point(x.from(), at), coordinate(x.to()));
      drawing.text(x.from() - 7.0, at + 4.5, tick.text,
                   {.style = "tick", .anchor = TextAnchor::end});
    }
    for (const ChartTick& tick : x.ticks_below(ticks_along(x, kPerTickX), kTextSize)) {
      const double at = x.at(tick.value);
      grid += fmt::format("M{}V{}", point(at, bottom), coordinate(y.to()));
      marks += fmt::format("M{}v4", point(at, bottom));
      const double half = 0.5 * text_width(tick.text, kTextSize);
      const double middle = std::min(at, width_ - half);
      drawing.text(middle, bottom + 17.0, tick.text,
                   {.style = "tick", .anchor = TextAnchor::middle});
    }
    drawing.path(grid, "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".13\"");
    drawing.path(fmt::format("{}M{}H{}", marks, point(x.from(), bottom), coordinate(x.to())),
                 "class=\"axis\" stroke=\"currentColor\" stroke-opacity=\".7\"");
    drawing.text(0.5 * (x.from() + x.to()), height_ - 7.0, chart_.x.label,
                 {.anchor = TextAnchor::middle, .most_width = x.to() - x.from()});
    draw_head(drawing);
  }

  // The label of y just above its axis; the legend beside it, else above it.
  void draw_head(SvgDrawing& drawing) const {
    const double last = 17.0 + ChartLegend::kRowHeight * std::max(0, legend_.rows() - 1);
    const bool is_beside = legend_.is_beside();
    drawing.text(4.0, is_beside ? 17.0 : last, chart_.y.label, {.most_width = width_ - 8.0});
    legend_.draw(drawing, is_beside ? 17.0 : 17.0 - ChartLegend::kRowHeight);
  }

  [[nodiscard]] static int ticks_along(const ChartScale& scale, double way) {
    return std::max(2, static_cast<int>(std::abs(scale.to() - scale.from()) / way));
  }

  void draw(SvgDrawing& drawing, const ChartSeries& series, const ChartScale& x,
            const ChartScale& y) {
    auto pieces = pieces_of(chart_, series);
    for (auto& piece : pieces) {
      for (DrawnPoint& at : piece) at = {x.at(at.x), y.at(at.y)};
    }
    if (series.mark == Mark::dots) {
      std::vector<DrawnPoint> points;
      for (const auto& piece : pieces) points.insert(points.end(), piece.begin(), piece.end());
      const double radius = mark_radius(points.size());
      drawing.path(shapes_path(series.style, points, radius),
                   shape_attributes(series.style, radius));
      for (const DrawnPoint& at : points) quiet_.add_point(at.x, at.y);
      return;
    }
    for (const auto& piece : pieces) {
      for (std::size_t i = 1; i < piece.size(); ++i) {
        quiet_.add_line(piece[i - 1].x, piece[i - 1].y, piece[i].x, piece[i].y);
      }
    }
    if (series.mark == Mark::bars) {
      drawing.path(bars_path(pieces, y.at(std::clamp(0.0, y.range().low, y.range().high))),
                   bar_attributes(series.style));
    } else {
      drawing.path(line_path(pieces), line_attributes(series.style));
    }
  }

  // Beside each dot, where the fewest others are.
  void tag(SvgDrawing& drawing, const ChartSeries& series, const ChartScale& x,
           const ChartScale& y) {
    for (std::size_t i = 0; i < std::min(series.tags.size(), count_of(series)); ++i) {
      if (!has_place(chart_, series.x[i], series.y[i])) continue;
      const DrawnPoint at{x.at(series.x[i]), y.at(series.y[i])};
      const double width = text_width(series.tags[i], kTextSize);
      std::vector<DrawnBox> boxes;
      for (const auto& [right, down] :
           {std::pair{6.0, -8.0}, std::pair{-6.0 - width, -8.0}, std::pair{-0.5 * width, -21.0},
            std::pair{-0.5 * width, 6.0}}) {
        const DrawnBox box{at.x + right, at.y + down, at.x + right + width, at.y + down + 15.0};
        if (box.left >= x.from() && box.right <= width_) boxes.push_back(box);
      }
      if (boxes.empty()) continue;
      const DrawnBox& box = boxes[quiet_.choose(boxes)];
      drawing.text(box.left, box.bottom - 3.5, series.tags[i], {.style = "tick", .has_halo = true});
      for (const double part : {0.2, 0.5, 0.8}) {
        quiet_.add_point(box.left + part * width, 0.5 * (box.top + box.bottom));
      }
    }
  }

  [[nodiscard]] static std::string bars_path(std::span<const std::vector<DrawnPoint>> pieces,
                                             double ground) {
    std::string path;
    for (const auto& piece : pieces) {
      for (std::size_t i = 0; i + 1 < piece.size(); i += 2) {
        if (std::abs(piece[i].y - ground) < 0.05) continue;
        path += fmt::format("M{}V{}H{}V{}z", point(piece[i].x, ground), coordinate(piece[i].y),
                            coordinate(piece[i + 1].x), coordinate(ground));
      }
    }
    return path;
  }

  void draw(SvgDrawing& drawing, const ChartLine& line, const ChartScale& x, const ChartScale& y) {
    if (!is_drawn(chart_, line)) return;
    const std::string attributes = fmt::format(
        "class=\"limit {}\" stroke=\"{}\" stroke-width=\"1.6\" stroke-dasharray=\"{}\"",
        tone_class(line.tone), tone_colour(line.tone), line.tone == Tone::neutral ? "2 3" : "6 3");
    if (line.is_vertical) {
      drawing.line(x.at(line.at), y.from(), x.at(line.at), y.to(), attributes);
      quiet_.add_line(x.at(line.at), y.from(), x.at(line.at), y.to());
    } else {
      drawing.line(x.from(), y.at(line.at), x.to(), y.at(line.at), attributes);
      quiet_.add_line(x.from(), y.at(line.at), x.to(), y.at(line.at));
    }
  }

  // Beside its line, where the fewest data are.
  void label(SvgDrawing& drawing, const ChartLine& line, const ChartScale& x, const ChartScale& y) {
    if (!is_drawn(chart_, line) || line.label.empty()) return;
    const double most = 0.6 * (x.to() - x.from());
    const double width = std::min(most, text_width(line.label, kTextSize));
    const std::vector<DrawnBox> boxes = line.is_vertical ? boxes_beside(x.at(line.at), width, x, y)
                                                         : boxes_along(y.at(line.at), width, x, y);
    if (boxes.empty()) return;
    const DrawnBox& box = boxes[quiet_.choose(boxes)];
    drawing.text(box.left, box.bottom - 4.0, line.label,
                 {.fill = tone_colour(line.tone), .has_halo = true, .most_width = most});
  }

  [[nodiscard]] std::vector<DrawnBox> boxes_along(double at, double width, const ChartScale& x,
                                                  const ChartScale& y) const {
    std::vector<DrawnBox> boxes;
    for (const double part : {1.0, 0.0, 0.75, 0.5, 0.25}) {
      const double left = x.from() + 4.0 + part * (x.to() - x.from() - width - 8.0);
      for (const double top : {at - 17.0, at + 2.0}) {
        const bool is_inside = top >= y.to() - 16.0 && top + 15.0 <= y.from();
        if (is_inside) boxes.push_back({left, top, left + width, top + 15.0});
      }
    }
    return boxes;
  }

  [[nodiscard]] std::vector<DrawnBox> boxes_beside(double at, double width, const ChartScale& x,
                                                   const ChartScale& y) const {
    std::vector<DrawnBox> boxes;
    for (const double part : {0.0, 1.0, 0.25, 0.5, 0.75}) {
      const double top = y.to() + 3.0 + part * (y.from() - y.to() - 21.0);
      for (const double left : {at + 5.0, at - 5.0 - width}) {
        const bool is_inside = left >= x.from() && left + width <= width_;
        if (is_inside) boxes.push_back({left, top, left + width, top + 15.0});
      }
    }
    return boxes;
  }

  const Chart& chart_;
  Ranges ranges_;
  double width_;
  double left_;
  ChartLegend legend_;
  double top_;
  double height_;
  QuietPlaces quiet_;
};

}  // namespace

Figure figure_of(const Chart& chart) {
  if (!has_data(chart)) {
    return {.id = chart.id,
            .title = chart.title,
            .text = chart.text,
            .svg = nothing_drawn(chart.title, chart.text, chart.nothing)};
  }
  return {.id = chart.id,
          .title = chart.title,
          .text = chart.text,
          .svg = ChartPicture(chart).svg(),
          .live = live_chart(chart),
          .is_wide = chart.is_wide};
}

}  // namespace armcal
