// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/calibration_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armcal/core/utc_time.h"
#include "armcal/report/chart/chart.h"
#include "armcal/report/chart/histogram.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/shown_number.h"

namespace armcal {
namespace {

constexpr int kFitStyle = 0;
constexpr int kCheckStyle = 1;

// Residuals (lengths) of fitted and of held-out rows over something that a row may have.
template <typename Abscissa>
void add_residuals(Chart& chart, const std::vector<ResidualRow>& rows, const Language& say,
                   const Abscissa& abscissa) {
  chart.y.label = say("figures.residual_axis");
  chart.y.low = 0.0;
  chart.nothing = say("figures.nothing");
  for (const bool check : {false, true}) {
    ChartSeries series;
    series.name = say(check ? "calibration.set_check" : "calibration.set_fit");
    series.style = check ? kCheckStyle : kFitStyle;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const ResidualRow& row = rows[i];
      const std::optional<double> x = row.is_check == check ? abscissa(row, i) : std::nullopt;
      if (!x) continue;
      series.x.push_back(*x);
      series.y.push_back(row.residual_mm);
      series.labels.push_back(row.place);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
}

std::size_t joint_count(const std::vector<ResidualRow>& rows) {
  std::size_t count = 0;
  for (const ResidualRow& row : rows) count = std::max(count, row.q_deg.size());
  return count;
}

Figure over_joint(const std::vector<ResidualRow>& rows, std::size_t joint, const Language& say) {
  Chart chart;
  chart.id = fmt::format("residual-joint-{}", joint + 1);
  chart.title = say("figures.over_joint", joint + 1);
  chart.x.label = say("figures.joint_axis", joint + 1);
  add_residuals(chart, rows, say, [&](const ResidualRow& row, std::size_t) {
    return joint < row.q_deg.size() ? std::optional(row.q_deg[joint]) : std::nullopt;
  });
  return figure_of(chart);
}

// Distance of the tip from the origin of the base.
Figure over_reach(const std::vector<ResidualRow>& rows, const Language& say) {
  Chart chart;
  chart.id = "residual-reach";
  chart.title = say("figures.over_reach");
  chart.text = say("figures.over_reach_text");
  chart.x.label = say("figures.reach_axis");
  add_residuals(chart, rows, say, [&](const ResidualRow& row, std::size_t) {
    return row.tip_mm ? std::optional(row.tip_mm->norm()) : std::nullopt;
  });
  return figure_of(chart);
}

// Hours since the first reading.
std::optional<Figure> over_time(const std::vector<ResidualRow>& rows, const Language& say) {
  std::vector<std::optional<double>> hours(rows.size());
  std::optional<double> first;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].time) continue;
    if (const auto seconds = parse_utc_time(*rows[i].time)) {
      hours[i] = static_cast<double>(*seconds) / 3600.0;
      first = std::min(first.value_or(*hours[i]), *hours[i]);
    }
  }
  if (!first) return std::nullopt;
  Chart chart;
  chart.id = "residual-time";
  chart.title = say("figures.over_time");
  chart.x.label = say("figures.time_axis");
  add_residuals(chart, rows, say, [&](const ResidualRow&, std::size_t i) {
    return hours[i] ? std::optional(*hours[i] - *first) : std::nullopt;
  });
  return figure_of(chart);
}

Figure over_order(const std::vector<ResidualRow>& rows, const Language& say) {
  Chart chart;
  chart.id = "residual-order";
  chart.title = say("figures.over_order");
  chart.text = say("figures.over_order_text");
  chart.x.label = say("figures.order_axis");
  add_residuals(chart, rows, say, [&](const ResidualRow&, std::size_t i) {
    return std::optional(static_cast<double>(i + 1));
  });
  return figure_of(chart);
}

std::vector<double> all_components(const std::vector<ResidualRow>& rows) {
  std::vector<double> components;
  for (const ResidualRow& row : rows) {
    if (row.is_check) continue;
    components.insert(components.end(), row.components.begin(), row.components.end());
  }
  return components;
}

Figure histogram_figure(const std::vector<double>& components, const Language& say) {
  Chart chart;
  chart.id = "residual-histogram";
  chart.title = say("figures.histogram");
  chart.text = say("figures.histogram_text", components.size());
  chart.x.label = say("figures.standardised_axis");
  chart.y.label = say("figures.count_axis");
  chart.nothing = say("figures.nothing");
  return figure_of(with_histogram(std::move(chart), say("figures.components"),
                                  say("figures.normal_density"), components));
}

Figure quantile_figure(const std::vector<double>& components, const Language& say) {
  Chart chart;
  chart.id = "residual-quantiles";
  chart.title = say("figures.quantiles");
  chart.text = say("figures.quantiles_text");
  chart.x.label = say("figures.normal_axis");
  chart.y.label = say("figures.standardised_axis");
  chart.nothing = say("figures.nothing");
  return figure_of(with_normal_quantiles(
      std::move(chart),
      {say("figures.components"), say("figures.as_stated"), say("figures.quantile_band")},
      components));
}

}  // namespace

Figures residual_figures(const std::vector<ResidualRow>& rows, const Language& say) {
  Figures figures;
  for (std::size_t joint = 0; joint < joint_count(rows); ++joint) {
    figures.items.push_back(over_joint(rows, joint, say));
  }
  figures.items.push_back(over_reach(rows, say));
  auto time = over_time(rows, say);
  figures.items.push_back(time ? std::move(*time) : over_order(rows, say));
  const std::vector<double> components = all_components(rows);
  figures.items.push_back(histogram_figure(components, say));
  figures.items.push_back(quantile_figure(components, say));
  return figures;
}

}  // namespace armcal
