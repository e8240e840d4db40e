// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/coverage_strips.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armcal/report/chart/legend.h"
#include "armcal/report/chart/scale.h"

namespace armcal {
namespace {

constexpr double kStripWidth = 480.0;
constexpr double kStrip = 16.0;
constexpr double kStripRow = 34.0;
constexpr double kStripAxis = 46.0;
constexpr double kStripMostNames = 110.0;
constexpr double kSpan = 64.0;      // of the widths at the right
constexpr std::size_t kBins = 120;  // of the whole axis
constexpr int kStripShades = 8;
constexpr double kStops[] = {5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0};  // between ticks

// Angles of more than 100 turns are an error of the readings and would hide all others.
constexpr double kMost_deg = 36000.0;

std::vector<double> drawable(const std::vector<double>& angles_deg) {
  std::vector<double> kept;
  for (const double angle : angles_deg) {
    if (std::abs(angle) <= kMost_deg) kept.push_back(angle);
  }
  return kept;
}

std::optional<ChartRange> range_of_joint(const JointStrip& joint) {
  const double limits[] = {joint.low_deg, joint.high_deg};
  return united(range_of(drawable({std::begin(limits), std::end(limits)}), AxisScale::linear),
                united(range_of(drawable(joint.fit_deg), AxisScale::linear),
                       range_of(drawable(joint.check_deg), AxisScale::linear)));
}

double tick_step(const ChartRange& range) {
  for (const double step : kStops) {
    if ((range.high - range.low) / step <= 6.0) return step;
  }
  return nice_step((range.high - range.low) / 6.0);
}

class StripPicture {
 public:
  StripPicture(const CoverageStrips& strips, const ChartRange& range)
      : strips_(strips),
        left_(left_margin(strips)),
        x_(AxisScale::linear, axis_range({}, range), left_, kStripWidth - kSpan - 8.0),
        legend_(entries(), 4.0, kStripWidth - kSpan - 8.0) {}

  [[nodiscard]] std::string svg() const {
    const double head = ChartLegend::kRowHeight * std::max(1, legend_.rows()) + 10.0;
    const double bottom = head + kStripRow * static_cast<double>(strips_.joints.size());
    SvgDrawing drawing(kStripWidth, bottom + kStripAxis);
    legend_.draw(drawing, 16.0);
    drawing.text(kStripWidth - 4.0, 16.0, strips_.span,
                 {.style = "tick", .anchor = TextAnchor::end, .most_width = kSpan});
    draw_axis(drawing, head, bottom);
    double top = head + 5.0;
    for (const JointStrip& joint : strips_.joints) {
      draw(drawing, joint, top);
      top += kStripRow;
    }
    return drawing.finished(strips_.title, strips_.text, "coverage");
  }

 private:
  [[nodiscard]] static double left_margin(const CoverageStrips& strips) {
    double widest = 0.0;
    for (const JointStrip& joint : strips.joints) {
      widest = std::max(widest, text_width(joint.name, kTextSize));
    }
    return std::min(widest, kStripMostNames) + 14.0;
  }

  [[nodiscard]] std::vector<LegendEntry> entries() const {
    std::vector<LegendEntry> entries;
    const auto any = [&](auto&& readings) {
      return std::any_of(strips_.joints.begin(), strips_.joints.end(),
                         [&](const JointStrip& joint) { return !readings(joint).empty(); });
    };
    if (any([](const JointStrip& joint) { return joint.fit_deg; }) && !strips_.fit.empty()) {
      entries.push_back({strips_.fit, [](SvgDrawing& drawing, double x, double y) {
                           drawing.rectangle(
                               x - 11.0, y - 6.0, 22.0, 12.0,
                               fmt::format("class=\"s0\" fill=\"{}\"", series_colour(0)));
                         }});
    }
    if (any([](const JointStrip& joint) { return joint.check_deg; }) && !strips_.check.empty()) {
      entries.push_back({strips_.check, [](SvgDrawing& drawing, double x, double y) {
                           drawing.path(fmt::format("M{}v10m5-10v10m4-10v10", point(x - 5, y - 5)),
                                        check_attributes());
                         }});
    }
    return entries;
  }

  [[nodiscard]] static std::string check_attributes() {
    return fmt::format("class=\"line s1\" stroke=\"{}\" stroke-width=\"1.4\"", series_colour(1));
  }

  void draw_axis(SvgDrawing& drawing, double top, double bottom) const {
    const double step = tick_step(x_.range());
    std::string grid;
    for (double i = std::ceil(x_.range().low / step); i * step <= x_.range().high; ++i) {
      grid += fmt::format("M{}V{}", point(x_.at(i * step), top), coordinate(bottom));
      drawing.text(x_.at(i * step), bottom + 16.0, signed_text(i * step, 0),
                   {.style = "tick", .anchor = TextAnchor::middle});
    }
    drawing.path(grid, "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".13\"");
    drawing.text(0.5 * (x_.from() + x_.to()), bottom + 36.0, strips_.axis,
                 {.anchor = TextAnchor::middle, .most_width = x_.to() - x_.from()});
  }

  void draw(SvgDrawing& drawing, const JointStrip& joint, double top) const {
    drawing.text(left_ - 8.0, top + 13.0, joint.name,
                 {.anchor = TextAnchor::end, .most_width = left_ - 10.0});
    const double low = x_.at(std::max(joint.low_deg, x_.range().low));
    const double high = x_.at(std::min(joint.high_deg, x_.range().high));
    drawing.rectangle(std::min(low, high), top, std::abs(high - low), kStrip,
                      "class=\"track\" fill=\"currentColor\" fill-opacity=\".06\" "
                      "stroke=\"currentColor\" stroke-opacity=\".35\"");
    const std::vector<double> fit = drawable(joint.fit_deg);
    draw_density(drawing, fit, top);
    std::string strokes;
    for (const double angle : drawable(joint.check_deg)) {
      strokes += fmt::format("M{}v6", point(x_.at(angle), top + kStrip + 2.0));
    }
    drawing.path(strokes, check_attributes());
    const auto covered = range_of(fit, AxisScale::linear);
    if (!covered) return;
    drawing.text(kStripWidth - 4.0, top + 13.0,
                 fmt::format("{:.0f}\u00b0", covered->high - covered->low),
                 {.style = "tick", .anchor = TextAnchor::end});
  }

  void draw_density(SvgDrawing& drawing, const std::vector<double>& angles, double top) const {
    const double width = (x_.to() - x_.from()) / kBins;
    std::array<int, kBins> counts{};
    int most = 0;
    for (const double angle : angles) {
      const auto bin = static_cast<std::size_t>((x_.at(angle) - x_.from()) / width);
      most = std::max(most, ++counts[std::min(bin, kBins - 1)]);
    }
    std::array<std::string, kStripShades> paths;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      if (counts[bin] == 0) continue;
      const int shade = (counts[bin] * kStripShades - 1) / most;
      paths[static_cast<std::size_t>(shade)] += fmt::format(
          "M{}h{}v{}h-{}z", point(x_.from() + width * static_cast<double>(bin), top + 1.0),
          coordinate(width), coordinate(kStrip - 2.0), coordinate(width));
    }
    for (int shade = 0; shade < kStripShades; ++shade) {
      // A single reading is seen too.
      const double opacity = 0.3 + 0.7 * (shade + 1.0) / kStripShades;
      drawing.path(paths[static_cast<std::size_t>(shade)],
                   fmt::format("class=\"s0\" fill=\"{}\" fill-opacity=\"{}\"", series_colour(0),
                               coordinate(opacity)));
    }
  }

  const CoverageStrips& strips_;
  double left_;
  ChartScale x_;
  ChartLegend legend_;
};

}  // namespace

Figure figure_of(const CoverageStrips& strips) {
  std::optional<ChartRange> range;
  for (const JointStrip& joint : strips.joints) range = united(range, range_of_joint(joint));
  return {.id = strips.id,
          .title = strips.title,
          .text = strips.text,
          .svg = range ? StripPicture(strips, *range).svg()
                       : nothing_drawn(strips.title, strips.text, strips.nothing)};
}

std::vector<Chart> views_of(const ReachedPoints& points) {
  std::vector<Chart> charts;
  for (const bool from_above : {true, false}) {
    Chart chart{.id = points.id + (from_above ? "-top" : "-side"),
                .title = from_above ? points.top_title : points.side_title,
                .text = points.text,
                .x = {.label = points.x},
                .y = {.label = from_above ? points.y : points.z},
                .nothing = points.nothing,
                .equal_scales = true};
    for (const bool is_check : {false, true}) {
      const Eigen::Matrix3Xd& at = is_check ? points.check_mm : points.fit_mm;
      if (at.cols() == 0) continue;
      const Eigen::RowVectorXd x = at.row(0);
      const Eigen::RowVectorXd y = at.row(from_above ? 1 : 2);
      chart.series.push_back({.name = is_check ? points.check : points.fit,
                              .style = is_check ? 1 : 0,
                              .x = {x.begin(), x.end()},
                              .y = {y.begin(), y.end()}});
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace armcal
