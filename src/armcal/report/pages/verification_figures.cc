// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "armcal/report/chart/chart.h"
#include "armcal/report/chart/limit_bars.h"
#include "armcal/report/pages/verdict_words.h"

namespace armcal {
namespace {

// The same thing looks the same on all charts of a page.
constexpr int kJudgedStyle = 0;
constexpr int kLimitStyle = 1;
constexpr int kAsFoundStyle = 6;  // hollow

LimitedValue limited(const VerifiedValue& value, const Language& say) {
  LimitedValue limited;
  limited.value = *value.value_mm;
  limited.U = value.U_mm.value_or(0.0);
  limited.text = fmt::format("{} mm", mm_text(value.value_mm, value.U_mm));
  if (value.verdict != Verdict::not_judged) limited.word = word_of(value.verdict, say);
  limited.tone = tone_of(value.verdict);
  return limited;
}

// Long titles ("single-point articulation, near zone, seat 1: 2 s") in the two lines of a bar: the
// second one is free where there is no symbol.
void set_title(const VerifiedRow& row, LimitBarRow& bar) {
  bar.name = row.title;
  bar.symbol = row.judged.symbol;
  for (const std::string_view comma : {", ", "\uff0c"}) {
    const std::size_t at = row.title.find(comma);
    if (at == std::string::npos || !bar.symbol.empty()) continue;
    bar.name = row.title.substr(0, at);
    bar.symbol = row.title.substr(at + comma.size());
  }
}

// @param has_both  an arm as left was verified too; a row that it gave nothing for is as found
LimitBarRow bar_of(const VerifiedRow& row, bool has_middle, bool has_both, const Language& say) {
  LimitBarRow bar;
  set_title(row, bar);
  const VerifiedValue& judged = row.judged;
  if (judged.mpe_mm) {
    bar.limit = say("verification.limit_of_bar", mm_text(judged.mpe_mm));
    bar.mpe = *judged.mpe_mm;
  }
  bar.is_two_sided = row.is_signed;
  bar.guard = judged.guard_mm.value_or(0.0);
  bar.is_undecided_beyond = has_middle;
  if (judged.value_mm) {
    (has_both && !row.as_found ? bar.as_found : bar.as_left) = limited(judged, say);
  }
  // Where the limit depends on the length, the two arms may be decided by different lengths: one
  // bar has one limit, so the value as found stands on it as the same share of its own.
  if (row.as_found && row.as_found->value_mm) {
    bar.as_found = limited(*row.as_found, say);
    if (judged.mpe_mm && row.as_found->mpe_mm && *row.as_found->mpe_mm > 0.0) {
      const double scale = *judged.mpe_mm / *row.as_found->mpe_mm;
      bar.as_found->value *= scale;
      bar.as_found->U *= scale;
    }
  }
  return bar;
}

bool have_lengths(const VerifiedRow& row) {
  return std::all_of(row.judged.parts.begin(), row.judged.parts.end(),
                     [](const VerifiedPart& part) { return part.length_mm.has_value(); });
}

std::string hover_of(const VerifiedPart& part) {
  return part.where.empty() ? part.name : fmt::format("{} ({})", part.name, part.where);
}

ChartSeries series_of(const VerifiedValue& value, bool over_length, int style, std::string name) {
  ChartSeries series;
  series.name = std::move(name);
  series.style = style;
  for (std::size_t i = 0; i < value.parts.size(); ++i) {
    const VerifiedPart& part = value.parts[i];
    series.x.push_back(over_length ? part.length_mm.value_or(std::nan(""))
                                   : static_cast<double>(i + 1));
    series.y.push_back(part.value_mm);
    series.labels.push_back(hover_of(part));
  }
  return series;
}

// The limit of each length, on both sides where errors have a sign.
void add_limits_of_lengths(const VerifiedRow& row, const Language& say, Chart& chart) {
  std::map<double, double> limits;
  for (const VerifiedPart& part : row.judged.parts) {
    if (part.length_mm && part.mpe_mm) limits[*part.length_mm] = *part.mpe_mm;
  }
  for (const double side : {1.0, -1.0}) {
    if (limits.empty() || (side < 0.0 && !row.is_signed)) continue;
    ChartSeries series;
    series.name = side > 0.0 ? say("verification.mpe") : std::string();
    series.mark = Mark::line;
    series.style = kLimitStyle;
    for (const auto& [length, mpe] : limits) {
      series.x.push_back(length);
      series.y.push_back(side * mpe);
    }
    chart.series.push_back(std::move(series));
  }
}

// The limit is of the statistic: it stands on the chart where that is the largest of the parts, not
// a mean, a scatter or a diameter of them.
void add_limit_of_parts(const VerifiedRow& row, const Language& say, Chart& chart) {
  const VerifiedValue& judged = row.judged;
  if (!judged.mpe_mm || !judged.largest_mm) return;
  const bool is_of_a_part =
      std::any_of(judged.parts.begin(), judged.parts.end(), [&](const VerifiedPart& part) {
        return std::abs(part.value_mm) == std::abs(*judged.largest_mm);
      });
  if (!is_of_a_part) return;
  chart.lines.push_back({false, *judged.mpe_mm, say("verification.mpe"), Tone::bad});
  if (row.is_signed) chart.lines.push_back({false, -*judged.mpe_mm, "", Tone::bad});
}

Figure part_figure(const VerifiedRow& row, std::size_t number, bool has_both, const Language& say) {
  const bool over_length = have_lengths(row);
  Chart chart;
  chart.id = fmt::format("parts-{}", number);
  chart.title = row.title;
  chart.text = say(over_length ? "verification.over_length" : "verification.over_parts");
  chart.x.label = say(over_length ? "verification.length_axis" : "verification.part_axis");
  chart.y.label = row.part_axis;
  chart.y.low = 0.0;
  chart.y.high = 0.0;
  chart.nothing = say("verification.no_values");
  if (!over_length) {
    chart.x.low = 0.5;
    chart.x.high = static_cast<double>(row.judged.parts.size()) + 0.5;
  }
  const std::string as_found = say("verification.as_found");
  if (row.as_found) {
    chart.series.push_back(series_of(*row.as_found, over_length, kAsFoundStyle, as_found));
  }
  if (has_both && !row.as_found) {
    chart.series.push_back(series_of(row.judged, over_length, kAsFoundStyle, as_found));
  } else {
    chart.series.push_back(series_of(row.judged, over_length, kJudgedStyle,
                                     has_both ? say("verification.as_left") : std::string()));
  }
  if (over_length) {
    add_limits_of_lengths(row, say, chart);
  } else {
    add_limit_of_parts(row, say, chart);
  }
  return figure_of(chart);
}

}  // namespace

Figure limit_figure(const std::vector<VerifiedRow>& rows, const std::string& rule,
                    const Language& say) {
  LimitBars bars;
  bars.id = "limits-of-tests";
  bars.title = say("verification.bars");
  bars.text = say("verification.bars_text");
  bars.nothing = say("verification.no_values");
  bars.as_found = say("verification.as_found");
  const bool has_both = have_as_left(rows);
  bars.as_left = say(has_both ? "verification.as_left" : "verification.value");
  bars.uncertainty = say("verification.reach_of_u");
  bars.passes = say("verification.passes_here");
  const bool has_middle = rule == "iso14253-1" || rule == "conformance-probability";
  bars.guarded = say(has_middle ? "verification.undecided_here" : "verification.fails_here");
  for (const VerifiedRow& row : rows) bars.rows.push_back(bar_of(row, has_middle, has_both, say));
  return figure_of(bars);
}

Figures part_figures(const std::vector<VerifiedRow>& rows, const Language& say) {
  Figures figures;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!are_worth_a_chart(rows[i]) || repeats_parts(rows, i)) continue;
    figures.items.push_back(part_figure(rows[i], i + 1, have_as_left(rows), say));
  }
  return figures;
}

}  // namespace armcal
