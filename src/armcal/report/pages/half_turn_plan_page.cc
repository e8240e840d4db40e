// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/half_turn_plan_page.h"

#include <fmt/format.h>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/arm_of.h"
#include "armcal/report/pages/posture_figures.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

Headlines half_turn_headlines(const DocumentView& document, const Language& say) {
  const auto readings = document.list("readings");
  return {
      {{say("half_turn_plan.readings"), whole(static_cast<double>(readings.size())), "",
        say("half_turn_plan.readings_note", whole(document.number("candidates")))},
       {say("half_turn_plan.length_error"), fixed(1e3 * document.number("length_error_mm"), 2),
        "\u00b5m", say("half_turn_plan.length_error_note")},
       {say("half_turn_plan.parameters"), whole(document.number("rank")), "",
        say("symmetric.condition_note", condition_text(document.number_if("condition_number")))},
       {say("half_turn_plan.redundancy"), fixed(document.number("least_redundancy"), 2), "",
        say("half_turn_plan.redundancy_note")}}};
}

Table half_turn_parameters(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("half_turn_plan.predicted");
  table.columns = {{say("parameters.name"), ColumnKind::text},
                   {"u"},
                   {say("parameters.unit"), ColumnKind::text}};
  for (const DocumentView& parameter : document.list("parameters")) {
    const ShownUnit shown = shown_unit(parameter.text("name"), parameter.text("unit"));
    const double u = shown.factor * parameter.number("u");
    table.rows.push_back(
        {{parameter.text("name")}, {fixed(u, decimals_for_uncertainty(u))}, {shown.unit}});
  }
  return table;
}

std::string angles_text(const std::vector<double>& deg) {
  std::string text;
  for (const double angle : deg) text += fmt::format("{}{:.1f}", text.empty() ? "" : "  ", angle);
  return text;
}

Table worksheet_of(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("half_turn_plan.worksheet");
  table.columns = {{say("symmetric.reading"), ColumnKind::text},
                   {say("symmetric.joint")},
                   {say("half_turn_plan.posture"), ColumnKind::text},
                   {say("half_turn_plan.distance")},
                   {"u, mm"},
                   {say("symmetric.redundancy")}};
  for (const DocumentView& reading : document.list("readings")) {
    table.rows.push_back({{reading.text("name")},
                          {whole(reading.number("joint"))},
                          {angles_text(reading.numbers("posture_deg"))},
                          {fixed(reading.number("distance_mm"), 3)},
                          {fixed(reading.number("u_mm"), 4)},
                          {fixed(reading.number("redundancy"), 3)}});
  }
  return table;
}

}  // namespace

Page half_turn_plan_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("half_turn_plan.title");
  page.sections.push_back({"summary",
                           say("calibration.summary"),
                           say("half_turn_plan.lead"),
                           {half_turn_headlines(document, say)}});
  page.sections.push_back({"worksheet",
                           say("half_turn_plan.worksheet_title"),
                           say("half_turn_plan.worksheet_lead"),
                           {worksheet_of(document, say)}});
  if (document.has("arm")) {
    std::vector<PostureReading> readings;
    for (const DocumentView& reading : document.list("readings")) {
      readings.push_back({reading, fmt::format("{} mm", fixed(reading.number("distance_mm"), 3))});
    }
    page.sections.push_back({"postures",
                             say("symmetric.postures"),
                             say("symmetric.postures_lead"),
                             {posture_figures(arm_of(document, "arm"), readings, say)}});
  }
  page.sections.push_back({"parameters",
                           say("parameters.title"),
                           say("half_turn_plan.parameters_lead"),
                           {half_turn_parameters(document, say)}});
  return page;
}

}  // namespace armcal
