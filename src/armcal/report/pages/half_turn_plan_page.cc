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
                   {say("parameters.unit"), ColumnKind::word}};
  for (const DocumentView& parameter : document.list("parameters")) {
    const ShownUnit shown = shown_unit(parameter.text("name"), parameter.text("unit"));
    const double u = shown.factor * parameter.number("u");
    table.rows.push_back(
        {{parameter.text("name")}, {fixed(u, decimals_for_uncertainty(u))}, {shown.unit}});
  }
  return table;
}

Table worksheet_of(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("half_turn_plan.worksheet");
  table.columns = {{say("symmetric.reading"), ColumnKind::text},
                   {say("symmetric.joint"), ColumnKind::word},
                   {say("half_turn_plan.turned_to")}};
  const std::vector<DocumentView> readings = document.list("readings");
  const std::size_t joints = readings.empty() ? 0 : readings.front().numbers("posture_deg").size();
  for (std::size_t j = 1; j <= joints; ++j) table.columns.push_back({fmt::format("q{}", j)});
  table.columns.insert(
      table.columns.end(),
      {{say("half_turn_plan.distance")}, {"u, mm"}, {say("symmetric.redundancy")}});
  for (const DocumentView& reading : readings) {
    const std::vector<double> start = reading.numbers("posture_deg");
    const std::vector<double> end = reading.numbers("posture_end_deg");
    if (start.size() != joints || end.size() != joints) {
      reading["posture_deg"].complain("has another number of joints than the reading before");
    }
    const auto turned =
        static_cast<std::size_t>(reading.ordinal("joint", static_cast<int>(joints)));
    std::vector<Cell> row = {
        {reading.text("name")}, {fmt::format("q{}", turned)}, {set_angle_text(end[turned - 1])}};
    for (const double each : start) row.push_back({set_angle_text(each)});
    row.insert(row.end(), {{fixed(reading.number("distance_mm"), 3)},
                           {fixed(reading.number("u_mm"), 4)},
                           {fixed(reading.number("redundancy"), 3)}});
    table.rows.push_back(std::move(row));
  }
  table.note = say("half_turn_plan.worksheet_note");
  return table;
}

Facts assumptions_of(const DocumentView& document, const Language& say) {
  const DocumentView wishes = document["wishes"];
  return {{{say("half_turn_plan.u_distance"), fmt::format("{:g} mm", wishes.number("u_mm"))},
           {say("half_turn_plan.u_encoder"),
            fmt::format("{:g}\u2033", wishes.number("u_encoder_arcsec"))},
           {say("half_turn_plan.repeats"), whole(wishes.number("repeats"))},
           {say("half_turn_plan.grid"), wishes.number("grid_deg") > 0.0
                                            ? fmt::format("{:g}\u00b0", wishes.number("grid_deg"))
                                            : std::string()}}};
}

}  // namespace

Page half_turn_plan_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("half_turn_plan.title");
  if (document.has("arm")) page.subtitle = arm_of(document, "arm").name;
  page.sections.push_back({"summary",
                           say("calibration.summary"),
                           say("half_turn_plan.lead"),
                           {half_turn_headlines(document, say), assumptions_of(document, say)}});
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
