// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/report/html/page.h"

namespace armcal {

enum class AxisScale { linear, logarithmic };

struct ChartAxis {
  std::string label;  ///< with unit: "reach, mm"
  AxisScale scale = AxisScale::linear;
  /// Ends that the axis has at least; the data widen it.
  std::optional<double> low, high;
};

enum class Mark {
  dots,
  line,
  steps,
  bars,  ///< of a histogram: x has one edge more than y has counts
};

/// Series differ by shape and dash as well as by colour.
struct ChartSeries {
  std::string name;  ///< in the legend; empty: not there
  Mark mark = Mark::dots;
  int style = 0;  ///< which colour and shape, from 0; the same number for the same thing on all
                  ///< charts of a page
  std::vector<double> x, y;
  std::vector<std::string> labels;  ///< of each point, for hovering ("cmm.csv:118"); or empty
  std::vector<std::string> tags;    ///< of each dot, drawn beside it (a number, a short name); or
                                    ///< empty
};

/// A line across the chart with a word: a limit, a mean.
struct ChartLine {
  bool is_vertical = false;
  double at = 0.0;
  std::string label;
  Tone tone = Tone::neutral;
};

struct Chart {
  std::string id;
  std::string title;
  std::string text;
  ChartAxis x, y;
  std::vector<ChartSeries> series;
  std::vector<ChartLine> lines;
  std::string nothing;        ///< said in the drawing where there is nothing to draw
  bool equal_scales = false;  ///< a millimetre is as long either way
  bool is_wide = false;
};

/// The chart as a figure: an SVG drawing and, beside it, the same for a script. Values that are not
/// finite are left out.
[[nodiscard]] Figure figure_of(const Chart& chart);

}  // namespace armcal
