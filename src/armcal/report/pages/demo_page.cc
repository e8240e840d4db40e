// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/demo_page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/calibration_page.h"
#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/pages/symmetric_point_page.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr int kPrintedDecimals = 3;  // of the paper's tables

Table table2_of(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("demo.table2");
  table.columns = {{say("parameters.name"), ColumnKind::text},
                   {say("demo.printed")},
                   {say("demo.literal")},
                   {say("demo.consistent")},
                   {say("parameters.unit"), ColumnKind::word}};
  const DocumentView printed = document["table2"];
  for (const auto& [name, ignored] : printed.json().items()) {
    const auto cell = [&document, &name = name](const char* key) {
      const auto value = document[key].number_if(name);
      return Cell{value ? fixed(*value, kPrintedDecimals) : "\u2013"};
    };
    table.rows.push_back(
        {{name}, cell("table2"), cell("literal_chain"), cell("consistent_chain"), {"mm"}});
  }
  table.note = say("demo.table2_note");
  return table;
}

Page paper(const DocumentView& document, const Language& say) {
  Page page = symmetric_point_page(document["as_printed"], say);
  page.title = say("demo.paper_title");
  const DocumentView sphere = document["sphere"];
  Section section{"paper", say("demo.paper_section"), say("demo.paper_lead"), {}};
  section.blocks.emplace_back(table2_of(document, say));
  section.blocks.emplace_back(Paragraph{
      say("demo.sphere", fixed(sphere.number("certified_diameter_mm"), 4),
          fixed(sphere.number("measured_diameter_mm"), 4), fixed(sphere.number("error_mm"), 4))});
  page.sections.insert(page.sections.begin() + 1, std::move(section));
  return page;
}

Table kits_of(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("demo.kits");
  table.columns = {{say("demo.kit"), ColumnKind::prose},
                   {say("compare.readings")},
                   {say("compare.rms")},
                   {say("compare.max")},
                   {say("demo.over_floor")},
                   {say("demo.scale")},
                   {say("compare.inside")}};
  const auto add = [&](const std::string& name, const DocumentView& truth) {
    const bool is_calibrated = truth.has("intervals");
    table.rows.push_back(
        {{name},
         {is_calibrated ? whole(truth.number("readings")) : "\u2013"},
         {fixed(truth.number("rms_mm"), 4)},
         {fixed(truth.number("max_mm"), 4)},
         {fixed(truth.number("ratio_to_floor"), 2)},
         {fixed(truth.number("scale_um_per_m"), 1)},
         {is_calibrated ? fmt::format("{:.0f}/{:.0f}", truth["intervals"].number("inside"),
                                      truth["intervals"].number("count"))
                        : "\u2013"}});
  };
  add(say("demo.as_drawn"), document["drawing"]);
  for (const DocumentView& kit : document.list("calibrations")) {
    add(in_language(kit.text("name"), "demo.phrase", say), kit);
  }
  table.note = say("demo.kits_note", fixed(document.number("floor_mm"), 4));
  return table;
}

Page virtual_arm(const DocumentView& document, const Language& say) {
  Page page = calibration_page(document["reference_cmm"], say);
  page.title = say("demo.virtual_title");
  const DocumentView cone = document["cone"];
  Section section{"truth", say("demo.truth"), say("demo.truth_lead"), {kits_of(document, say)}};
  section.blocks.emplace_back(Notice{Tone::warning,
                                     say("demo.cone_title"),
                                     {say("demo.cone", fixed(cone.number("rms_mm"), 5),
                                          fixed(cone.number("rms_mm_of_grown_arm"), 5),
                                          fmt::format("{:g}", 100.0 * cone.number("growth")))}});
  page.sections.insert(page.sections.begin(), std::move(section));
  return page;
}

}  // namespace

Page demo_page(const DocumentView& document, const Language& say) {
  return document.has("as_printed") ? paper(document, say) : virtual_arm(document, say);
}

}  // namespace armcal
