// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/sphere_test_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/deviations_figure.h"
#include "armcal/report/pages/sphere_map.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

// "diameter error" becomes sphere_test.value.diameter_error; other names stay.
std::string sphere_title(const DocumentView& test, const Language& say) {
  const std::string name = test.text("name");
  std::string key = fmt::format("sphere_test.value.{}", name);
  std::replace(key.begin(), key.end(), ' ', '_');
  return say.has(key) ? say(key) : name;
}

Stamp sphere_stamp(const DocumentView& document, const Language& say) {
  const Verdict verdict = verdict_in(document);
  std::vector<std::string> sentences = {
      say(fmt::format("sphere_test.sentence.{}", to_string(verdict)))};
  if (document.has("blind_spots") && !document.list("blind_spots").empty()) {
    sentences.push_back(say("sphere_test.sentence.blind"));
  }
  Stamp stamp = armcal::stamp_of(verdict, run_on(sentences, say), say);
  if (verdict == Verdict::pass && sentences.size() > 1) stamp.tone = Tone::warning;
  return stamp;
}

Headlines sphere_headlines(const DocumentView& document, const Language& say) {
  Headlines headlines;
  for (const DocumentView& test : document.list("tests")) {
    const auto value = test.number_if("value_mm");
    const auto limit = test.number_if("mpe_mm");
    headlines.items.push_back(
        {sphere_title(test, say), mm_text(value), value ? "mm" : "",
         limit ? say("sphere_test.limit_note", mm_text(limit)) : say("sphere_test.no_limit_note"),
         tone_of(verdict_in(test))});
  }
  const auto u = document.number_if("u_diameter_mm");
  headlines.items.push_back(
      {say("sphere_test.diameter"), mm_text(document.number("diameter_mm"), u), "mm",
       say("sphere_test.certified_note", mm_text(document.number("certified_diameter_mm"))),
       Tone::neutral});
  if (u) {
    headlines.items.push_back({say("sphere_test.u_diameter"), mm_text(u, u), "mm",
                               say("sphere_test.u_diameter_note"), Tone::neutral});
  }
  return headlines;
}

Table sphere_tests_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("sphere_test.tests");
  table.columns = {{say("sphere_test.test"), ColumnKind::text},
                   {say("verification.value_mm")},
                   {say("sphere_test.limit_mm")},
                   {say("verification.verdict_column"), ColumnKind::text}};
  for (const DocumentView& test : document.list("tests")) {
    table.rows.push_back({{sphere_title(test, say)},
                          {mm_text(test.number_if("value_mm"))},
                          {mm_text(test.number_if("mpe_mm"))},
                          verdict_cell(verdict_in(test), say)});
  }
  table.note = say("sphere_test.tests_note");
  return table;
}

Facts facts_of(const DocumentView& document, const Language& say) {
  const auto u = document.number_if("u_diameter_mm");
  const DocumentView sphere = document["sphere"];
  const auto mm = [](const std::string& number) { return fmt::format("{} mm", number); };
  Facts facts;
  facts.rows = {
      {say("check.arm"), document.text_if("arm").value_or("")},
      {say("sphere_test.certified"), mm(mm_text(document.number("certified_diameter_mm")))},
      {say("sphere_test.diameter"), mm(mm_text(document.number("diameter_mm"), u))},
      {say("sphere_test.relative"),
       fmt::format("{} %", percent_text(document.number("relative_error"), 4))},
      {say("sphere_test.points"), whole(sphere.number("count"))},
      {say("sphere_test.rms"), mm(mm_text(sphere.number("rms_mm")))}};
  if (const double tip = document.number("tip_diameter_mm"); tip > 0.0) {
    facts.rows.emplace_back(say("sphere_test.tip"), mm(mm_text(tip)));
    facts.rows.emplace_back(say("sphere_test.with_tip"),
                            mm(mm_text(document.number("uncompensated_diameter_mm"), u)));
  }
  return facts;
}

// The form error is the distance between the outer lines.
Figure figure_in_order(const std::vector<double>& deviations, const Language& say) {
  return deviations_figure(
      deviations,
      {say("sphere_test.in_order"), say("sphere_test.in_order_text"), say("sphere_test.point_axis"),
       say("sphere_test.deviation_axis"), "sphere_test.point"},
      say);
}

Figure figure_by_direction(const DocumentView& document, const std::vector<double>& deviations,
                           const Language& say) {
  SphereMap map;
  map.id = "deviation-direction";
  map.title = say("sphere_test.by_direction");
  map.text = say("sphere_test.by_direction_text");
  map.nothing = say("sphere_test.no_points");
  map.upper = say("sphere_test.upper_half");
  map.lower = say("sphere_test.lower_half");
  map.outside = say("sphere_test.outside");
  map.inside = say("sphere_test.inside");
  for (const DocumentView& each : document.list("directions")) {
    const std::vector<double> direction = each.as_numbers();
    if (direction.size() != 3) each.complain("is no direction of three numbers");
    map.directions.emplace_back(direction[0], direction[1], direction[2]);
  }
  if (map.directions.size() != deviations.size()) {
    document["directions"].complain("has another length than sphere.residuals_mm");
  }
  map.deviations_mm = deviations;
  return figure_of(map);
}

Section points_section(const DocumentView& document, const Language& say) {
  const std::vector<double> deviations = document["sphere"].numbers("residuals_mm");
  Figures figures{{figure_in_order(deviations, say)}};
  if (document.has("directions")) {
    figures.items.push_back(figure_by_direction(document, deviations, say));
  }
  return {"points", say("sphere_test.points_title"), say("sphere_test.points_lead"), {figures}};
}

Table spans_table(const std::vector<double>& spans_deg, const Language& say) {
  Table table;
  table.caption = say("sphere_test.spans");
  table.columns = {{say("sphere_test.joint"), ColumnKind::text}, {say("sphere_test.span")}};
  for (std::size_t i = 0; i < spans_deg.size(); ++i) {
    table.rows.push_back({{fmt::format("q{}", i + 1)}, {fixed(spans_deg[i], 1)}});
  }
  return table;
}

Table blind_table(const std::vector<DocumentView>& spots, const Language& say) {
  constexpr std::size_t kShown = 12;
  Table table;
  table.caption = say("sphere_test.blind_spots");
  table.columns = {{say("sphere_test.parameter"), ColumnKind::text}, {say("sphere_test.shown")}};
  for (const DocumentView& each : spots) {
    table.rows.push_back({{each.text("parameter")}, {fixed(each.number("shown_mm_per_mm"), 3)}});
  }
  table.note = say("sphere_test.blind_note");
  table.shown = kShown;
  return table;
}

Section sphere_unseen_section(const DocumentView& document, const Language& say) {
  Section section{"unseen", say("sphere_test.unseen"), "", {}};
  const std::vector<double> spans_deg = document.numbers("joint_spans_deg");
  const std::vector<DocumentView> spots = document.list("blind_spots");
  if (spans_deg.empty()) {
    section.blocks.emplace_back(Paragraph{say("sphere_test.coordinates_only")});
    return section;
  }
  if (spots.empty()) {
    section.blocks.emplace_back(Paragraph{say("sphere_test.all_seen")});
  } else {
    section.blocks.emplace_back(
        Notice{Tone::warning, say("sphere_test.blind"), {say("sphere_test.blind_remedy")}});
    section.blocks.emplace_back(blind_table(spots, say));
  }
  section.blocks.emplace_back(spans_table(spans_deg, say));
  return section;
}

}  // namespace

Page sphere_test_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("sphere_test.title");
  page.subtitle = say("sphere_test.subtitle", mm_text(document.number("certified_diameter_mm")));
  page.stamp = sphere_stamp(document, say);
  Section summary{"summary", say("verification.summary"), "", {}};
  summary.blocks = {sphere_headlines(document, say), sphere_tests_table(document, say),
                    facts_of(document, say)};
  page.sections = {std::move(summary), points_section(document, say),
                   sphere_unseen_section(document, say)};
  return page;
}

}  // namespace armcal
