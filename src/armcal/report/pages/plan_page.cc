// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/plan_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/pages/plan_figures.h"
#include "armcal/report/pages/verdict_words.h"

namespace armcal {
namespace {

constexpr const char* kPlanPhrases = "verification_plan.phrase";
constexpr double kHardlyMoved = 0.25;  // of the range of a joint

std::string plan_title(const DocumentView& test, const Language& say) {
  return in_language(test.text("title"), kPlanPhrases, say);
}

std::string millimetres(const DocumentView& list) {
  std::string text;
  for (const double each : list.as_numbers()) {
    text += fmt::format("{}{:g}", text.empty() ? "" : ", ", each);
  }
  return fmt::format("{} mm", text);
}

std::size_t points_of(const DocumentView& document) {
  std::size_t points = 0;
  for (const DocumentView& test : document.list("tests")) points += test.list("readings").size();
  return points;
}

Headlines plan_headlines(const DocumentView& document, const Language& say) {
  const std::vector<double> coverage = document.numbers("joint_coverage");
  Headlines headlines;
  headlines.items = {
      {say("verification_plan.points"), fmt::format("{}", points_of(document)), "",
       say("verification_plan.points_note", document.list("tests").size()), Tone::neutral},
      {say("verification_plan.reach"), fixed(document.number("reach_mm"), 0), "mm",
       say("verification_plan.reach_note"), Tone::neutral}};
  if (!coverage.empty()) {
    const double least = *std::min_element(coverage.begin(), coverage.end());
    headlines.items.push_back({say("verification_plan.least_coverage"), percent_text(least), "%",
                               say("verification_plan.least_coverage_note"),
                               least < kHardlyMoved ? Tone::warning : Tone::neutral});
  }
  return headlines;
}

Facts wishes_of(const DocumentView& document, const Language& say) {
  const DocumentView wishes = document["wishes"];
  const auto mm = [&](const char* key) { return fmt::format("{:g} mm", wishes.number(key)); };
  Facts facts;
  facts.rows = {{say("verification_plan.sphere"), mm("sphere_diameter_mm")},
                {say("verification_plan.tip"), mm("tip_diameter_mm")}};
  if (!wishes.list("lengths_mm").empty()) {
    facts.rows.emplace_back(say("verification_plan.lengths"), millimetres(wishes["lengths_mm"]));
  }
  const std::vector<double> bars = wishes.numbers("bars_mm");
  if (std::any_of(bars.begin(), bars.end(), [](double each) { return each > 0.0; })) {
    facts.rows.emplace_back(say("verification_plan.bars"), millimetres(wishes["bars_mm"]));
  }
  return facts;
}

std::vector<Cell> coverage_row(const std::string& title, std::size_t points,
                               const std::vector<double>& coverage) {
  std::vector<Cell> cells = {{title}, {fmt::format("{}", points)}};
  for (const double share : coverage) {
    cells.push_back({percent_text(share), share < kHardlyMoved ? Tone::warning : Tone::neutral});
  }
  return cells;
}

Table coverage_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("verification_plan.coverage");
  const std::vector<double> together = document.numbers("joint_coverage");
  table.columns = {{say("verification_plan.test"), ColumnKind::prose},
                   {say("verification_plan.points")}};
  for (std::size_t j = 1; j <= together.size(); ++j)
    table.columns.push_back({fmt::format("q{}", j)});
  for (const DocumentView& test : document.list("tests")) {
    table.rows.push_back(coverage_row(plan_title(test, say), test.list("readings").size(),
                                      test.numbers("joint_coverage")));
  }
  table.rows.push_back(
      coverage_row(say("verification_plan.together"), points_of(document), together));
  table.note = say("verification_plan.coverage_note");
  return table;
}

void add_point(const Eigen::Vector3d& point, int decimals, std::vector<Cell>& cells) {
  for (const double each : point) cells.push_back({fixed(each, decimals)});
}

Table plan_places_table(const std::vector<DocumentView>& tests, const Language& say) {
  Table table;
  table.caption = say("verification_plan.places");
  table.columns = {{say("verification_plan.test"), ColumnKind::prose},
                   {say("verification_plan.thing"), ColumnKind::text},
                   {say("verification_plan.position_column"), ColumnKind::text},
                   {"x, mm"},
                   {"y, mm"},
                   {"z, mm"},
                   {say("verification_plan.free_side", "x")},
                   {say("verification_plan.free_side", "y")},
                   {say("verification_plan.free_side", "z")}};
  const auto add = [&](const DocumentView& test, const char* thing, const std::string& position,
                       const Eigen::Vector3d& at_mm, const Eigen::Vector3d& free_side) {
    std::vector<Cell> cells = {
        {plan_title(test, say)}, {say(thing)}, {plan_position(position, say)}};
    add_point(at_mm, 1, cells);
    add_point(free_side, 2, cells);
    table.rows.push_back(std::move(cells));
  };
  for (const DocumentView& test : tests) {
    for (const DocumentView& sphere : test.list("spheres")) {
      add(test, "verification_plan.legend.sphere", sphere.text("position"),
          point_under(sphere, "center_mm"), point_under(sphere, "pole"));
    }
    for (const DocumentView& seat : test.list("seats")) {
      add(test, "verification_plan.legend.seat", seat.text("zone"), point_under(seat, "at_mm"),
          point_under(seat, "axis"));
    }
  }
  table.note = say("verification_plan.places_note");
  return table;
}

Table bars_table(const std::vector<DocumentView>& tests, const Language& say) {
  Table table;
  table.caption = say("verification_plan.bars_table");
  table.columns = {{say("verification_plan.test"), ColumnKind::prose},
                   {say("verification_plan.position_column"), ColumnKind::text},
                   {say("verification_plan.length")},
                   {"A x, mm"},
                   {"A y, mm"},
                   {"A z, mm"},
                   {"B x, mm"},
                   {"B y, mm"},
                   {"B z, mm"}};
  for (const DocumentView& test : tests) {
    for (const DocumentView& bar : test.list("bars")) {
      const std::vector<double> lengths = bar.numbers("lengths_mm");
      std::vector<Cell> cells = {{plan_title(test, say)},
                                 {plan_position(bar.text("position"), say)},
                                 {lengths.empty() ? std::string() : fixed(lengths.back(), 1)}};
      add_point(point_under(bar, "end_A_mm"), 1, cells);
      add_point(point_under(bar, "end_B_mm"), 1, cells);
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

Facts covers_of(const std::vector<DocumentView>& tests, const Language& say) {
  Facts facts;
  for (const DocumentView& test : tests) {
    facts.rows.emplace_back(plan_title(test, say),
                            in_language(test.text("covers"), kPlanPhrases, say));
  }
  return facts;
}

Section standard_section(const DocumentView& document, const std::string& standard,
                         const std::vector<DocumentView>& tests, std::size_t number,
                         const Language& say) {
  const std::string id = fmt::format("placement-{}", number);
  Section section{id, say("verification_plan.placement", standard), "", {}};
  Figures figures = plan_figures(document, tests, id, say);
  if (!figures.items.empty()) section.blocks.emplace_back(std::move(figures));
  section.blocks.push_back(covers_of(tests, say));
  Table places = plan_places_table(tests, say);
  if (!places.rows.empty()) section.blocks.emplace_back(std::move(places));
  Table bars = bars_table(tests, say);
  if (!bars.rows.empty()) section.blocks.emplace_back(std::move(bars));
  return section;
}

struct Standard {
  std::string name;
  std::vector<DocumentView> tests;
};

// In the order of the document; plans that were saved before tests said their standard are one.
std::vector<Standard> standards_of(const DocumentView& document, const Language& say) {
  std::vector<Standard> standards;
  for (const DocumentView& test : document.list("tests")) {
    const std::string name =
        test.text_if("standard").value_or(say("verification_plan.all_standards"));
    const auto at = std::find_if(standards.begin(), standards.end(),
                                 [&](const Standard& each) { return each.name == name; });
    if (at == standards.end()) {
      standards.push_back({name, {test}});
    } else {
      at->tests.push_back(test);
    }
  }
  return standards;
}

}  // namespace

Page verification_plan_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("verification_plan.title");
  page.subtitle = document.text_if("arm_name").value_or("");
  Section summary{"summary", say("verification.summary"), "", {}};
  summary.blocks = {plan_headlines(document, say), wishes_of(document, say),
                    coverage_table(document, say)};
  page.sections = {std::move(summary)};
  const std::vector<Standard> standards = standards_of(document, say);
  for (std::size_t i = 0; i < standards.size(); ++i) {
    page.sections.push_back(
        standard_section(document, standards[i].name, standards[i].tests, i + 1, say));
  }
  return page;
}

}  // namespace armcal
