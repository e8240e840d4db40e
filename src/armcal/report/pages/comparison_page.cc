// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "armcal/report/chart/chart.h"
#include "armcal/report/comparison_cells.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr const char* kComparisonPhrases = "compare.phrase";

// A method as a point of a chart: numbered as in its table.
struct Point {
  std::size_t number = 0;
  std::string title;
  double x = 0.0;
  double error_mm = 0.0;
};

Figure scatter(const char* id, const std::string& title, const std::string& axis,
               const std::vector<Point>& points, const std::optional<double>& floor_mm,
               const Language& say) {
  Chart chart;
  chart.id = id;
  chart.title = title;
  chart.text = say("compare.numbers_text");
  chart.nothing = say("compare.nothing");
  chart.x = {axis, AxisScale::logarithmic, {}, {}};
  chart.y = {say("compare.error_axis"), AxisScale::logarithmic, {}, {}};
  ChartSeries series;
  for (const Point& point : points) {
    series.x.push_back(point.x);
    series.y.push_back(point.error_mm);
    series.tags.push_back(fmt::format("{}", point.number));
    series.labels.push_back(point.title);
  }
  chart.series.push_back(std::move(series));
  if (floor_mm) chart.lines.push_back({false, *floor_mm, say("compare.floor"), Tone::neutral});
  return figure_of(chart);
}

// "simulated annealing, all parameters" is a name with an addition.
std::string said(const std::string& phrase, const Language& say) {
  constexpr std::string_view kAddition = ", all parameters";
  if (phrase.ends_with(kAddition)) {
    const std::string name = phrase.substr(0, phrase.size() - kAddition.size());
    const std::string named = in_language(name, kComparisonPhrases, say);
    if (named != name) return say("compare.phrase.with_all", named);
  }
  return in_language(phrase, kComparisonPhrases, say);
}

std::string title_in(const DocumentView& method, const Language& say) {
  return said(method.text("title"), say);
}

std::string comparison_remark(const DocumentView& method, const Language& say) {
  std::string remark = said(method.text_if("remark").value_or(""), say);
  if (const auto problem = method.text_if("problem")) {
    remark += fmt::format("{}{}", remark.empty() ? "" : "; ", said(*problem, say));
  }
  return remark;
}

// The point with the smallest error; nothing where there is none.
std::optional<Point> best_of(const std::vector<Point>& points) {
  const auto best = std::min_element(
      points.begin(), points.end(),
      [](const Point& one, const Point& other) { return one.error_mm < other.error_mm; });
  return best == points.end() ? std::nullopt : std::optional(*best);
}

// --- methods on a drawn arm

std::vector<Cell> drawn_row(const DocumentView& method, std::size_t number, const Language& say) {
  std::vector<Cell> row = {{fmt::format("{}", number)},
                           {title_in(method, say)},
                           {said(method.text("needs"), say)},
                           {whole(method.number("readings"))}};
  if (!method.has("point_rms_mm")) {
    row.resize(11);
  } else {
    for (const char* key : {"point_rms_mm", "point_mean_mm", "point_max_mm", "length_rms_mm"}) {
      row.push_back({error_cell(method.number(key))});
    }
    row.push_back({ratio_cell(method.number("noise_ratio"))});
    const bool has_intervals = method.number("intervals") > 0;
    row.push_back({has_intervals ? fmt::format("{:.0f}/{:.0f}", method.number("inside"),
                                               method.number("intervals"))
                                 : ""});
    row.push_back({seconds_cell(method.number("seconds"))});
  }
  row.push_back({comparison_remark(method, say)});
  return row;
}

Table drawn_table(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{"#", ColumnKind::word},
                   {say("compare.method"), ColumnKind::prose},
                   {say("compare.needs"), ColumnKind::prose},
                   {say("compare.readings")},
                   {say("compare.rms")},
                   {say("compare.mean")},
                   {say("compare.max")},
                   {say("compare.length")},
                   {say("compare.over_noise")},
                   {say("compare.inside")},
                   {say("compare.time")},
                   {say("compare.remark"), ColumnKind::prose}};
  for (const DocumentView& method : document.list("methods")) {
    table.rows.push_back(drawn_row(method, table.rows.size() + 1, say));
  }
  table.note = say("compare.drawn_note", fixed(document.number("noise_floor_mm"), 4));
  return table;
}

// What can be shown of a method: errors that are not of an arm as it came, by the readings it took.
struct DrawnPoints {
  std::vector<Point> over_time, over_readings;
  std::optional<double> nominal_mm;
};

DrawnPoints points_of(const DocumentView& document, const Language& say) {
  DrawnPoints points;
  std::size_t number = 0;
  for (const DocumentView& method : document.list("methods")) {
    ++number;
    if (!method.has("point_rms_mm")) continue;
    const double error_mm = method.number("point_rms_mm");
    const double readings = method.number("readings");
    if (readings <= 0) {
      points.nominal_mm = error_mm;
      continue;
    }
    const std::string title = title_in(method, say);
    points.over_time.push_back({number, title, method.number("seconds"), error_mm});
    points.over_readings.push_back({number, title, readings, error_mm});
  }
  return points;
}

Headlines drawn_headlines(const DocumentView& document, const DrawnPoints& points,
                          const Language& say) {
  Headlines headlines;
  headlines.items.push_back({say("compare.compared"),
                             whole(static_cast<double>(document.list("methods").size())), "",
                             say("compare.compared_note", whole(document.number("repeats")),
                                 whole(document.number("budget"))),
                             Tone::neutral});
  if (points.nominal_mm) {
    headlines.items.push_back({say("compare.uncalibrated"), error_cell(*points.nominal_mm), "mm",
                               say("compare.uncalibrated_note"), Tone::neutral});
  }
  if (const auto best = best_of(points.over_readings)) {
    headlines.items.push_back({say("compare.best"), error_cell(best->error_mm), "mm",
                               say("compare.best_note", best->title), Tone::neutral});
  }
  headlines.items.push_back({say("compare.floor_headline"),
                             fixed(document.number("noise_floor_mm"), 4), "mm",
                             say("compare.floor_headline_note"), Tone::neutral});
  return headlines;
}

Figures drawn_figures(const DocumentView& document, const DrawnPoints& points,
                      const Language& say) {
  const double floor_mm = document.number("noise_floor_mm");
  return {{scatter("error-over-time", say("compare.over_time"), say("compare.time_axis"),
                   points.over_time, floor_mm, say),
           scatter("error-over-readings", say("compare.over_readings"),
                   say("compare.readings_axis"), points.over_readings, floor_mm, say)}};
}

Page drawn_arms(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("compare.title");
  page.subtitle =
      fmt::format("{}: {}", document.text("scenario"), said(document.text("title"), say));
  const DrawnPoints points = points_of(document, say);
  const Facts facts{
      {{say("compare.u_reference"), fmt::format("{:g} mm", document.number("u_reference_mm"))}}};
  page.sections.push_back(
      {"summary",
       say("compare.summary"),
       say("compare.drawn_lead"),
       {drawn_headlines(document, points, say), drawn_figures(document, points, say)}});
  page.sections.push_back(
      {"methods", say("compare.methods"), "", {facts, drawn_table(document, say)}});
  return page;
}

// --- methods on the readings of a session

std::vector<Cell> session_row(const DocumentView& method, std::size_t number, const Language& say) {
  const bool has_figures = method.has("fitted") && method.has("held_out");
  std::vector<Cell> row = {{fmt::format("{}", number)},
                           {title_in(method, say)},
                           {has_figures ? whole(method.number("parameters")) : ""}};
  if (!has_figures) {
    row.resize(8);
  } else {
    const DocumentView judged = method["held_out"];
    row.push_back({error_cell(method["fitted"].number("rms_mm"))});
    for (const char* key : {"rms_mm", "mean_mm", "max_mm"}) {
      row.push_back({error_cell(judged.number(key))});
    }
    const auto over_stated = judged.number_if("over_stated");
    row.push_back({over_stated ? ratio_cell(*over_stated) : ""});
  }
  row.push_back({has_figures ? seconds_cell(method.number("seconds")) : ""});
  row.push_back({comparison_remark(method, say)});
  return row;
}

Page session(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{"#", ColumnKind::word},       {say("compare.method"), ColumnKind::prose},
                   {say("compare.parameters")},   {say("compare.fitted_rms")},
                   {say("compare.held_out_rms")}, {say("compare.mean")},
                   {say("compare.max")},          {say("compare.over_stated")},
                   {say("compare.time")},         {say("compare.remark"), ColumnKind::prose}};
  std::vector<Point> points;
  std::optional<double> nominal_mm;
  for (const DocumentView& method : document.list("methods")) {
    const std::size_t number = table.rows.size() + 1;
    table.rows.push_back(session_row(method, number, say));
    if (!method.has("held_out")) continue;
    if (method.number("parameters") <= 0) {
      nominal_mm = method["held_out"].number("rms_mm");
      continue;
    }
    points.push_back({number, title_in(method, say), method.number("seconds"),
                      method["held_out"].number("rms_mm")});
  }
  Page page;
  page.title = say("compare.title");
  page.subtitle = document.text("arm_name");
  Headlines headlines;
  headlines.items.push_back({say("compare.compared"), whole(static_cast<double>(table.rows.size())),
                             "",
                             say("compare.compared_session_note", whole(document.number("fitted")),
                                 whole(document.number("held_out"))),
                             Tone::neutral});
  if (nominal_mm) {
    headlines.items.push_back({say("compare.uncalibrated"), error_cell(*nominal_mm), "mm",
                               say("compare.uncalibrated_note"), Tone::neutral});
  }
  if (const auto best = best_of(points)) {
    headlines.items.push_back({say("compare.best_session"), error_cell(best->error_mm), "mm",
                               say("compare.best_note", best->title), Tone::neutral});
  }
  Figures figures{{scatter("error-over-time", say("compare.over_time"), say("compare.time_axis"),
                           points, std::nullopt, say)}};
  page.sections.push_back(
      {"summary", say("compare.summary"), say("compare.session_lead"), {headlines, figures}});
  page.sections.push_back({"methods", say("compare.methods"), "", {std::move(table)}});
  return page;
}

// --- what the paper of 2016 neglects

std::string whole_percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

Page paper_sphere(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{say("compare.neglected"), ColumnKind::prose},
                   {say("compare.size"), ColumnKind::prose},
                   {say("compare.arms")},
                   {say("compare.one_median")},
                   {say("compare.one_largest")},
                   {say("compare.one_share")},
                   {say("compare.five_median")},
                   {say("compare.five_largest")},
                   {say("compare.five_share")},
                   {say("compare.form")}};
  for (const DocumentView& effect : document.list("effects")) {
    std::vector<Cell> row = {{said(effect.text("name"), say)},
                             {with_micro_sign(said(effect.text("brief"), say))},
                             {whole(effect.number("arms"))}};
    for (const char* key : {"one_articulation", "five_articulations"}) {
      const DocumentView errors = effect[key];
      row.push_back({error_cell(errors.number("median_mm"))});
      row.push_back({error_cell(errors.number("largest95_mm"))});
      row.push_back({whole_percent(errors.number("share_as_large"))});
    }
    row.push_back({error_cell(effect["five_articulations"].number("median_form_mm"))});
    table.rows.push_back(std::move(row));
  }
  Page page;
  page.title = say("compare.paper_title");
  const std::string error = fmt::format("{:g} mm", document.number("diameter_error_mm"));
  page.subtitle =
      say("compare.paper_subtitle", fmt::format("{:g} mm", document.number("diameter_mm")), error);
  page.sections.push_back(
      {"effects", say("compare.effects"), say("compare.paper_lead", error), {std::move(table)}});
  return page;
}

}  // namespace

Page comparison_page(const DocumentView& document, const Language& say) {
  if (document.has("effects")) return paper_sphere(document, say);
  return document.has("scenario") ? drawn_arms(document, say) : session(document, say);
}

}  // namespace armcal
