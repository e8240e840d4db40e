// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/comparison_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "armcal/report/chart/chart.h"
#include "armcal/report/comparison_cells.h"
#include "armcal/report/number_format.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

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

std::string comparison_remark(const DocumentView& method) {
  std::string remark = method.text_if("remark").value_or("");
  if (const auto problem = method.text_if("problem")) {
    remark += fmt::format("{}{}", remark.empty() ? "" : "; ", *problem);
  }
  return remark;
}

// --- methods on a drawn arm

std::vector<Cell> drawn_row(const DocumentView& method, std::size_t number) {
  std::vector<Cell> row = {{fmt::format("{}", number)},
                           {method.text("title")},
                           {method.text("needs")},
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
  row.push_back({comparison_remark(method)});
  return row;
}

Table drawn_table(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{"#"},
                   {say("compare.method"), false},
                   {say("compare.needs"), false},
                   {say("compare.readings")},
                   {say("compare.rms")},
                   {say("compare.mean")},
                   {say("compare.max")},
                   {say("compare.length")},
                   {say("compare.over_noise")},
                   {say("compare.inside")},
                   {say("compare.time")},
                   {say("compare.remark"), false}};
  for (const DocumentView& method : document.list("methods")) {
    table.rows.push_back(drawn_row(method, table.rows.size() + 1));
  }
  table.note = say("compare.drawn_note", fixed(document.number("noise_floor_mm"), 4));
  return table;
}

Figures drawn_figures(const DocumentView& document, const Language& say) {
  std::vector<Point> over_time, over_readings;
  std::size_t number = 0;
  for (const DocumentView& method : document.list("methods")) {
    ++number;
    if (!method.has("point_rms_mm") || method.number("readings") <= 0) continue;
    const double error_mm = method.number("point_rms_mm");
    over_time.push_back({number, method.text("title"), method.number("seconds"), error_mm});
    over_readings.push_back({number, method.text("title"), method.number("readings"), error_mm});
  }
  const double floor_mm = document.number("noise_floor_mm");
  return {{scatter("error-over-time", say("compare.over_time"), say("compare.time_axis"), over_time,
                   floor_mm, say),
           scatter("error-over-readings", say("compare.over_readings"),
                   say("compare.readings_axis"), over_readings, floor_mm, say)}};
}

Page drawn_arms(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("compare.title");
  page.subtitle = fmt::format("{}: {}", document.text("scenario"), document.text("title"));
  Facts facts{
      {{say("compare.arms"), whole(document.number("repeats"))},
       {say("compare.budget"), whole(document.number("budget"))},
       {say("compare.u_reference"), fmt::format("{:g} mm", document.number("u_reference_mm"))},
       {say("compare.floor_fact"), fixed(document.number("noise_floor_mm"), 4) + " mm"}}};
  page.sections.push_back({"methods",
                           say("compare.methods"),
                           say("compare.drawn_lead"),
                           {facts, drawn_table(document, say), drawn_figures(document, say)}});
  return page;
}

// --- methods on the readings of a session

std::vector<Cell> session_row(const DocumentView& method, std::size_t number) {
  std::vector<Cell> row = {
      {fmt::format("{}", number)}, {method.text("title")}, {whole(method.number("parameters"))}};
  const bool has_figures = method.has("fitted") && method.has("held_out");
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
  row.push_back({seconds_cell(method.number("seconds"))});
  row.push_back({comparison_remark(method)});
  return row;
}

Page session(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{"#"},
                   {say("compare.method"), false},
                   {say("compare.parameters")},
                   {say("compare.fitted_rms")},
                   {say("compare.held_out_rms")},
                   {say("compare.mean")},
                   {say("compare.max")},
                   {say("compare.over_stated")},
                   {say("compare.time")},
                   {say("compare.remark"), false}};
  std::vector<Point> points;
  for (const DocumentView& method : document.list("methods")) {
    const std::size_t number = table.rows.size() + 1;
    table.rows.push_back(session_row(method, number));
    if (!method.has("held_out") || method.number("parameters") <= 0) continue;
    points.push_back({number, method.text("title"), method.number("seconds"),
                      method["held_out"].number("rms_mm")});
  }
  Page page;
  page.title = say("compare.title");
  page.subtitle = document.text("arm_name");
  Facts facts{{{say("compare.fitted_rows"), whole(document.number("fitted"))},
               {say("compare.held_out_rows"), whole(document.number("held_out"))}}};
  Figures figures{{scatter("error-over-time", say("compare.over_time"), say("compare.time_axis"),
                           points, std::nullopt, say)}};
  page.sections.push_back(
      {"methods", say("compare.methods"), say("compare.session_lead"), {facts, table, figures}});
  return page;
}

// --- what the paper of 2016 neglects

std::string whole_percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

Page paper_sphere(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{say("compare.neglected"), false},
                   {say("compare.size"), false},
                   {say("compare.arms")},
                   {say("compare.one_median")},
                   {say("compare.one_largest")},
                   {say("compare.one_share")},
                   {say("compare.five_median")},
                   {say("compare.five_largest")},
                   {say("compare.five_share")},
                   {say("compare.form")}};
  for (const DocumentView& effect : document.list("effects")) {
    std::vector<Cell> row = {
        {effect.text("name")}, {effect.text("brief")}, {whole(effect.number("arms"))}};
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
