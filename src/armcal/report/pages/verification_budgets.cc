// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_budgets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/phrase_book.h"

namespace armcal {
namespace {

constexpr std::array kSources = {"certificate", "form", "temperature", "expansion",
                                 "repeatability"};
constexpr std::size_t kShown = 12;

std::string micrometres(double mm) { return fixed(micrometres_from_millimetres(mm), 2); }

// Contributions of one source together.
std::string of_source(const DocumentView& budget, std::string_view source) {
  double squares = 0.0;
  bool any = false;
  for (const DocumentView& each : budget.list("contributions")) {
    if (each.text("source") != source) continue;
    any = true;
    squares += std::pow(each.number("u_mm"), 2);
  }
  return any ? micrometres(std::sqrt(squares)) : "\u2013";
}

Table table_by_source(const Language& say) {
  Table table;
  table.caption = say("verification.budget.by_source");
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.budget.of"), ColumnKind::text}};
  for (const char* source : kSources) {
    table.columns.push_back({say(fmt::format("verification.budget.source.{}", source))});
  }
  table.columns.insert(table.columns.end(),
                       {{say("verification.budget.u")}, {say("verification.budget.U")}});
  table.shown = kShown;
  return table;
}

Table table_of_contributions(const Language& say) {
  Table table;
  table.caption = say("verification.budget.contributions");
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.budget.of"), ColumnKind::text},
                   {say("verification.budget.contribution"), ColumnKind::text},
                   {say("verification.budget.u_of_input")},
                   {say("verification.budget.unit"), ColumnKind::word},
                   {say("verification.budget.sensitivity")},
                   {say("verification.budget.u_of_result")}};
  table.shown = kShown;
  return table;
}

void add_by_source(const std::string& title, const std::string& of, const DocumentView& budget,
                   Table& table) {
  std::vector<Cell> cells = {{title}, {of}};
  for (const char* source : kSources) cells.push_back({of_source(budget, source)});
  cells.push_back({micrometres(budget.number("u_mm"))});
  cells.push_back({micrometres(budget.number("U_mm"))});
  table.rows.push_back(std::move(cells));
}

void add_contributions(const std::string& title, const std::string& of, const DocumentView& budget,
                       const Language& say, Table& table) {
  for (const DocumentView& each : budget.list("contributions")) {
    table.rows.push_back({{title},
                          {of},
                          {in_language(each.text("name"), "verification.phrase", say)},
                          {fmt::format("{:.3g}", each.number("u"))},
                          {each.text("unit")},
                          {fmt::format("{:.4g}", each.number("sensitivity"))},
                          {micrometres(each.number("u_mm"))}});
  }
}

}  // namespace

std::optional<Section> budgets_section(const DocumentView& document,
                                       const std::vector<VerifiedRow>& rows, const Language& say) {
  Table sources = table_by_source(say);
  Table contributions = table_of_contributions(say);
  const std::vector<DocumentView> tests = document.list("tests");
  for (std::size_t i = 0; i < tests.size(); ++i) {
    for (const DocumentView& budget : tests[i].list("budgets")) {
      if (budget.list("contributions").empty()) continue;
      const std::string of = budget.text_if("of").value_or("");
      add_by_source(rows.at(i).title, of, budget, sources);
      add_contributions(rows.at(i).title, of, budget, say, contributions);
    }
  }
  if (sources.rows.empty()) return std::nullopt;
  const double k = document["decision"].number("coverage_factor");
  return Section{"uncertainty",
                 say("verification.budget.title"),
                 say("verification.budget.lead", fmt::format("{:g}", k)),
                 {std::move(sources), std::move(contributions)}};
}

}  // namespace armcal
