// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/control_chart_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "armcal/core/utc_time.h"
#include "armcal/numerics/distributions.h"
#include "armcal/report/chart/chart.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"
#include "armcal/report/trend_chart.h"

namespace armcal {
namespace {

constexpr int kUsualStyle = 0;  // and of the line through the checks
constexpr int kBrokenStyle = 1;
constexpr int kBandStyle = 2;
constexpr double kSeconds_per_day = 86400.0;

TrendDrift drift_of(const DocumentView& drift) {
  return {.mm_per_day = drift.number("mm_per_day"),
          .u_mm_per_day = drift.number("u_mm_per_day"),
          .now_mm = drift.number_if("now_mm"),
          .days_to_limit = drift.number_if("days_to_limit"),
          .is_significant = drift.flag("significant")};
}

ChartSeries series_of(const TrendHistory& trend, bool broken, const Language& say) {
  ChartSeries series;
  series.name = say(broken ? "check.breaks_a_rule" : "check.checks");
  series.style = broken ? kBrokenStyle : kUsualStyle;
  for (const TrendCheck& each : trend.checks) {
    if (each.breaks_a_rule != broken) continue;
    series.x.push_back(each.days);
    series.y.push_back(each.value_mm);
    series.labels.push_back(say("check.check_of_day", each.number, each.time.substr(0, 10)));
  }
  return series;
}

// Standard uncertainty of the drift's line at a day, from the scatter about it; nothing for fewer
// than three checks or for checks of one time. theory/interim_check.md eq. (4)-(5)
std::optional<double> u_of_line(const TrendHistory& trend, double day) {
  const auto count = static_cast<double>(trend.checks.size());
  if (trend.checks.size() < 3) return std::nullopt;
  double mean = 0.0;
  for (const TrendCheck& each : trend.checks) mean += each.days / count;
  double tt = 0.0;
  for (const TrendCheck& each : trend.checks) tt += std::pow(each.days - mean, 2);
  if (!(tt > 0.0)) return std::nullopt;
  return trend.drift->u_mm_per_day * std::sqrt(tt / count + std::pow(day - mean, 2));
}

void add_drift(const TrendHistory& trend, const Language& say, Chart& chart) {
  if (!trend.drift || !trend.drift->now_mm || trend.checks.size() < 3) return;
  constexpr double kBothTails = 0.975;
  constexpr int kSteps = 24;
  const double reach =
      student_t_quantile(kBothTails, static_cast<double>(trend.checks.size()) - 2.0);
  double last = 0.0;
  for (const TrendCheck& each : trend.checks) last = std::max(last, each.days);
  for (const double side : {0.0, 1.0, -1.0}) {
    ChartSeries line;
    line.mark = Mark::line;
    line.style = side == 0.0 ? kUsualStyle : kBandStyle;
    if (side >= 0.0) line.name = say(side == 0.0 ? "check.drift" : "check.drift_band");
    for (int i = 0; i <= kSteps; ++i) {
      const double day = last * i / kSteps;
      const auto u = u_of_line(trend, day);
      if (!u) return;
      line.x.push_back(day);
      line.y.push_back(*trend.drift->now_mm + trend.drift->mm_per_day * (day - last) +
                       side * reach * *u);
    }
    chart.series.push_back(std::move(line));
  }
}

// Limits of the check that are drawn with it.
std::vector<double> limits_on_chart(const TrendHistory& trend) {
  if (!trend.limit_mm) return {};
  std::optional<ControlLimits> control;
  if (trend.centre_mm && trend.sigma_mm) control = {*trend.centre_mm, *trend.sigma_mm};
  std::vector<double> values_mm;
  for (const TrendCheck& each : trend.checks) values_mm.push_back(each.value_mm);
  std::vector<double> near;
  for (const double limit_mm : {*trend.limit_mm, -*trend.limit_mm}) {
    if (limit_mm < 0.0 && !trend.is_signed) continue;
    if (is_on_chart(limit_mm, values_mm, control)) near.push_back(limit_mm);
  }
  return near;
}

void add_lines(const TrendHistory& trend, const Language& say, Chart& chart) {
  if (trend.centre_mm && trend.sigma_mm) {
    chart.lines.push_back({false, *trend.centre_mm, say("check.centre"), Tone::neutral});
    const double band = 3.0 * *trend.sigma_mm;
    if (band > 0.0) {
      chart.lines.push_back(
          {false, *trend.centre_mm + band, say("check.plus_3_sigma"), Tone::warning});
      chart.lines.push_back(
          {false, *trend.centre_mm - band, say("check.minus_3_sigma"), Tone::warning});
    }
  }
  for (const double limit_mm : limits_on_chart(trend)) {
    chart.lines.push_back({false, limit_mm, say("check.limit"), Tone::bad});
  }
}

std::string text_of(const TrendHistory& trend, const Language& say) {
  std::vector<std::string> sentences;
  if (trend.centre_mm && trend.sigma_mm) {
    sentences.push_back(say("check.centre_text", mm_text(trend.centre_mm, trend.sigma_mm),
                            mm_text(trend.sigma_mm, trend.sigma_mm), trend.baseline));
  } else {
    sentences.push_back(say("check.no_centre_text", trend.baseline, trend.checks.size()));
  }
  if (trend.limit_mm && limits_on_chart(trend).empty()) {
    sentences.push_back(say("check.far_limit_text", mm_text(trend.limit_mm)));
  }
  return run_on(sentences, say);
}

}  // namespace

std::string title_of_check_value(const std::string& name, const Language& say) {
  const std::string key = fmt::format("check.value.{}", name);
  return say.has(key) ? say(key) : name;
}

TrendHistory trend_history(const DocumentView& trend, const Language& say) {
  TrendHistory history;
  history.name = trend.text("name");
  history.title = title_of_check_value(history.name, say);
  history.limit_mm = trend.number_if("limit_mm");
  history.centre_mm = trend.number_if("centre_mm");
  history.sigma_mm = trend.number_if("sigma_mm");
  history.is_signed = trend.has("is_signed") && trend.flag("is_signed");
  history.baseline = whole(trend.number("baseline"));
  std::set<std::string> broken;
  for (const DocumentView& each : trend.list("violations")) {
    broken.insert(whole(each.number("check")));
  }
  std::optional<double> first;
  for (const DocumentView& each : trend.list("checks")) {
    const std::string time = each.text("time");
    const auto seconds = parse_utc_time(time);
    if (!seconds) each["time"].complain("is no time as 2026-01-05T08:00:00Z");
    const double days = static_cast<double>(*seconds) / kSeconds_per_day;
    first = first.value_or(days);
    const std::string number = whole(each.number("check"));
    history.checks.push_back(
        {number, time, days - *first, each.number("value_mm"), broken.contains(number)});
  }
  if (trend.has("drift")) history.drift = drift_of(trend["drift"]);
  return history;
}

Figure control_chart_figure(const TrendHistory& trend, std::size_t number, const Language& say) {
  Chart chart;
  chart.id = fmt::format("trend-{}", number);
  chart.title = trend.title;
  chart.text = text_of(trend, say);
  chart.nothing = say("check.no_checks");
  chart.is_wide = true;
  chart.x.label = trend.checks.empty()
                      ? std::string()
                      : say("check.day_axis", trend.checks.front().time.substr(0, 10));
  chart.y.label = say("check.value_axis");
  add_drift(trend, say, chart);
  for (const bool broken : {false, true}) {
    ChartSeries series = series_of(trend, broken, say);
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  add_lines(trend, say, chart);
  return figure_of(chart);
}

}  // namespace armcal
