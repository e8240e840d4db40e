// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/probe_page.h"

#include <fmt/format.h>

#include "armcal/report/calibration_quality.h"
#include "armcal/report/chart/interval_chart.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

// sqrt of the 95 % quantile of chi-squared with three degrees of freedom
constexpr double kSameStylus = 2.795;
constexpr double kCoverage = 2.0;
constexpr double kLittleSwing_deg = 20.0;

bool scatters_more(const DocumentView& document) {
  return scatters_more_than_stated(document.number("sigma0"), document.number("chi2_probability"));
}

std::string change_sentence(const DocumentView& document, const Language& say) {
  return say(document.number("change_in_u") > kSameStylus ? "probe.another_stylus"
                                                          : "probe.same_stylus");
}

Stamp probe_stamp(const DocumentView& document, const Language& say) {
  const Verdict verdict = verdict_in(document);
  const std::string U = mm_text(document.number("U_mm"));
  const std::string limit = mm_text(document.number_if("limit_mm"));
  const std::string sentence = say(fmt::format("probe.sentence.{}", to_string(verdict)), U, limit);
  return {say(fmt::format("probe.stamp.{}", to_string(verdict))),
          run_on({sentence, change_sentence(document, say)}, say), tone_of(verdict)};
}

Headlines probe_headlines(const DocumentView& document, const Language& say) {
  const auto limit = document.number_if("limit_mm");
  const DocumentView group = document.list("groups").at(0);
  Headlines headlines;
  headlines.items = {
      {say("probe.U"), mm_text(document.number("U_mm")), "mm",
       limit ? say("probe.limit_note", mm_text(limit)) : say("probe.U_note"),
       tone_of(verdict_in(document))},
      {say("probe.change"), mm_text(document.number("change_mm")), "mm",
       say("probe.change_note", fixed(document.number("change_in_u"), 1)), Tone::neutral},
      {say("probe.residuals"), mm_text(group.number("rms_mm")), "mm",
       say("probe.residuals_note", whole(group.number("count")), mm_text(group.number("max_mm"))),
       Tone::neutral},
      {say("calibration.sigma0"), fixed(document.number("sigma0"), 2), "",
       scatters_more(document) ? say("probe.scatters_more")
                               : say("calibration.sigma0_note", whole(document.number("dof"))),
       scatters_more(document) ? Tone::warning : Tone::neutral}};
  return headlines;
}

std::vector<Cell> cells_of(const DocumentView& coordinate) {
  const double u = coordinate.number("u_mm");
  const double old_mm = coordinate.number("old_mm");
  const double value_mm = coordinate.number("value_mm");
  const int decimals = decimals_for_uncertainty(u);
  const double swing_deg = coordinate.number("swing_deg");
  return {{coordinate.text("name")},
          {fixed(old_mm, decimals)},
          {fixed(value_mm, decimals)},
          {fixed(value_mm - old_mm, decimals)},
          {fixed(u, decimals)},
          {fixed(kCoverage * u, decimals)},
          {fixed(coordinate.number("change_in_u"), 1)},
          {fixed(swing_deg, 0), swing_deg < kLittleSwing_deg ? Tone::warning : Tone::neutral}};
}

Table probe_tip_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("probe.tip");
  table.columns = {{say("probe.coordinate"), ColumnKind::text},
                   {say("probe.before")},
                   {say("probe.after")},
                   {say("probe.change_mm")},
                   {say("probe.u_mm")},
                   {say("probe.U_mm")},
                   {say("probe.change_over_u")},
                   {say("probe.swing")}};
  for (const DocumentView& each : document.list("tip")) table.rows.push_back(cells_of(each));
  table.note = say("probe.tip_note");
  return table;
}

Figure change_figure(const DocumentView& document, const Language& say) {
  IntervalChart chart;
  chart.id = "change-of-tip";
  chart.title = say("probe.figure");
  chart.text = say("probe.figure_text");
  chart.nothing = say("probe.nothing");
  chart.estimated = say("probe.change_and_U");
  IntervalGroup group;
  group.label = say("probe.change_mm");
  for (const DocumentView& each : document.list("tip")) {
    const double change = each.number("value_mm") - each.number("old_mm");
    const double U = kCoverage * each.number("u_mm");
    const int decimals = decimals_for_uncertainty(each.number("u_mm"));
    group.rows.push_back({each.text("name"), change, U,
                          fmt::format("{} \u00b1 {}", fixed(change, decimals), fixed(U, decimals)),
                          false});
  }
  chart.groups.push_back(std::move(group));
  return figure_of(chart);
}

Facts stated_of(const DocumentView& document, const Language& say) {
  Facts facts;
  if (!document.has("stated")) return facts;
  const DocumentView stated = document["stated"];
  const auto add = [&](const char* label, const char* key, const char* unit) {
    const auto value = stated.number_if(key);
    if (!value || *value == 0.0) return;
    facts.rows.emplace_back(say(label), fmt::format("{:g}{}", *value, unit));
  };
  add("probe.sphere", "sphere_diameter_mm", " mm");
  add("probe.tip_diameter", "tip_diameter_mm", " mm");
  add("probe.stated_u", "u_mm", " mm");
  add("probe.stated_u_encoder", "u_encoder_arcsec", "\u2033");
  return facts;
}

}  // namespace

Page probe_page(const DocumentView& document, const Language& say) {
  if (document.list("groups").empty()) document["groups"].complain("is empty");
  Page page;
  page.title = say("probe.title");
  page.subtitle = document.text("arm_name");
  page.stamp = probe_stamp(document, say);
  Section summary{"summary", say("verification.summary"), "", {}};
  summary.blocks = {probe_headlines(document, say), stated_of(document, say),
                    probe_tip_table(document, say), Figures{{change_figure(document, say)}}};
  page.sections = {std::move(summary)};
  return page;
}

}  // namespace armcal
