// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armcal/report/pages/verdict_words.h"

namespace armcal {
namespace {

// A seat is no artefact: where nothing is known to be uncertain, nothing is claimed to be exact.
std::optional<double> claimed(const std::optional<double>& U_mm) {
  return U_mm && *U_mm > 0.0 ? U_mm : std::nullopt;
}

std::vector<Cell> cells_of(const VerifiedRow& row, bool has_both, const Language& say) {
  const VerifiedValue& judged = row.judged;
  std::vector<Cell> cells = {{row.title}, {judged.symbol.empty() ? "\u2013" : judged.symbol}};
  if (has_both) {
    const VerifiedValue& found = row.as_found ? *row.as_found : judged;
    cells.push_back({mm_text(found.value_mm, found.U_mm), tone_of(found.verdict)});
    cells.push_back({row.as_found ? mm_text(judged.value_mm, judged.U_mm) : mm_text({})});
  } else {
    cells.push_back({mm_text(judged.value_mm, judged.U_mm)});
  }
  cells.insert(cells.end(), {{mm_text(judged.mpe_mm)},
                             {mm_text(claimed(judged.U_mm), judged.U_mm)},
                             {percent_text(judged.share_of_mpe)},
                             verdict_cell(judged.verdict, say)});
  return cells;
}

const VerifiedPart* part_named(const VerifiedValue& value) {
  const auto at = std::find_if(value.parts.begin(), value.parts.end(),
                               [&](const auto& part) { return part.name == value.decided_by; });
  return at == value.parts.end() ? nullptr : &*at;
}

std::string part_text(const VerifiedValue& value, std::size_t part) {
  return part < value.parts.size() ? mm_text(value.parts[part].value_mm, value.U_mm) : mm_text({});
}

std::vector<Cell> cells_of_part(const VerifiedRow& row, std::size_t part, bool has_both) {
  const VerifiedPart& judged = row.judged.parts[part];
  std::vector<Cell> cells = {{row.title}, {judged.name}};
  if (has_both) cells.push_back({part_text(row.as_found ? *row.as_found : row.judged, part)});
  const bool has_value = row.as_found || !has_both;
  cells.push_back({has_value ? part_text(row.judged, part) : mm_text({})});
  cells.push_back({judged.where});
  return cells;
}

}  // namespace

Table tests_table(const std::vector<VerifiedRow>& rows, bool has_both, double coverage_factor,
                  const Language& say) {
  Table table;
  table.caption = say("verification.tests");
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.symbol"), ColumnKind::text}};
  if (has_both) {
    table.columns.push_back({say("verification.as_found_mm")});
    table.columns.push_back({say("verification.as_left_mm")});
  } else {
    table.columns.push_back({say("verification.value_mm")});
  }
  table.columns.insert(table.columns.end(),
                       {{say("verification.mpe_mm")},
                        {say("verification.U_mm", fmt::format("{:g}", coverage_factor))},
                        {say("verification.share")},
                        {say("verification.verdict_column"), ColumnKind::text}});
  for (const VerifiedRow& row : rows) table.rows.push_back(cells_of(row, has_both, say));
  table.note = say("verification.tests_note");
  if (has_both) table.note = run_on({table.note, say("verification.as_found_note")}, say);
  return table;
}

Table deciding_table(const std::vector<VerifiedRow>& rows, const Language& say) {
  Table table;
  table.caption = say("verification.decides");
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.decided_by"), ColumnKind::prose},
                   {say("verification.from"), ColumnKind::prose},
                   {say("verification.limit"), ColumnKind::text}};
  for (const VerifiedRow& row : rows) {
    if (row.judged.decided_by.empty()) continue;
    const VerifiedPart* part = part_named(row.judged);
    table.rows.push_back({{row.title},
                          {row.judged.decided_by},
                          {part == nullptr ? std::string() : part->where},
                          {row.limit}});
  }
  return table;
}

Table few_parts_table(const std::vector<VerifiedRow>& rows, const Language& say) {
  const bool has_both = have_as_left(rows);
  Table table;
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.part"), ColumnKind::text}};
  if (has_both) table.columns.push_back({say("verification.as_found_mm")});
  table.columns.push_back({say(has_both ? "verification.as_left_mm" : "verification.value_mm")});
  table.columns.push_back({say("verification.from"), ColumnKind::prose});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (are_worth_a_chart(rows[i]) || repeats_parts(rows, i)) continue;
    for (std::size_t part = 0; part < rows[i].judged.parts.size(); ++part) {
      table.rows.push_back(cells_of_part(rows[i], part, has_both));
    }
  }
  return table;
}

Table definitions_table(const std::vector<VerifiedRow>& rows, const Language& say) {
  Table table;
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.definition"), ColumnKind::prose}};
  std::set<std::string> told;
  for (const VerifiedRow& row : rows) {
    if (told.insert(row.definition).second) table.rows.push_back({{row.title}, {row.definition}});
  }
  return table;
}

}  // namespace armcal
