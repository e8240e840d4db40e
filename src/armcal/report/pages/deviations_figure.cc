// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/deviations_figure.h"

#include <algorithm>

#include "armcal/report/chart/chart.h"

namespace armcal {

bool have_signs(const std::vector<double>& deviations_mm) {
  return std::any_of(deviations_mm.begin(), deviations_mm.end(),
                     [](double each) { return each < 0.0; });
}

Figure deviations_figure(const std::vector<double>& deviations_mm, const DeviationWords& words,
                         const Language& say) {
  Chart chart;
  chart.id = "deviation-order";
  chart.title = words.title;
  chart.text = words.text;
  chart.nothing = say("sphere_test.no_points");
  chart.x.label = words.point_axis;
  chart.x.low = 0.5;
  chart.x.high = static_cast<double>(deviations_mm.size()) + 0.5;
  chart.y.label = words.deviation_axis;
  ChartSeries series;
  for (std::size_t i = 0; i < deviations_mm.size(); ++i) {
    series.x.push_back(static_cast<double>(i + 1));
    series.y.push_back(deviations_mm[i]);
    series.labels.push_back(say(words.point, i + 1));
  }
  if (have_signs(deviations_mm)) {
    const auto [low, high] = std::minmax_element(deviations_mm.begin(), deviations_mm.end());
    chart.lines = {{false, *high, say("sphere_test.largest"), Tone::neutral},
                   {false, *low, say("sphere_test.smallest"), Tone::neutral},
                   {false, 0.0, "", Tone::neutral}};
  }
  chart.series.push_back(std::move(series));
  return figure_of(chart);
}

}  // namespace armcal
