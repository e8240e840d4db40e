// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/verdict_words.h"

namespace armcal {
namespace {

constexpr std::size_t kShownParts = 12;

// A seat is no artefact: where nothing is known to be uncertain, nothing is claimed to be exact.
std::optional<double> claimed(const std::optional<double>& U_mm) {
  return U_mm && *U_mm > 0.0 ? U_mm : std::nullopt;
}

// Where the limit depends on the length, the two arms may be decided by different lengths.
bool has_limits_of_its_own(const std::vector<VerifiedRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const VerifiedRow& row) {
    return row.as_found && row.as_found->mpe_mm != row.judged.mpe_mm;
  });
}

std::vector<Cell> cells_of(const VerifiedRow& row, bool has_both, bool own_limits,
                           const Language& say) {
  const VerifiedValue& judged = row.judged;
  std::vector<Cell> cells = {{row.title}, {judged.symbol.empty() ? "\u2013" : judged.symbol}};
  if (has_both) {
    const VerifiedValue& found = row.as_found ? *row.as_found : judged;
    cells.push_back({mm_text(found.value_mm, found.U_mm), tone_of(found.verdict)});
    if (own_limits) cells.push_back({mm_text(found.mpe_mm)});
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
  const bool own_limits = has_both && has_limits_of_its_own(rows);
  Table table;
  table.caption = say("verification.tests");
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.symbol"), ColumnKind::text}};
  if (has_both) {
    table.columns.push_back({say("verification.as_found_mm")});
    if (own_limits) table.columns.push_back({say("verification.mpe_as_found_mm")});
    table.columns.push_back({say("verification.as_left_mm")});
  } else {
    table.columns.push_back({say("verification.value_mm")});
  }
  table.columns.insert(table.columns.end(),
                       {{say("verification.mpe_mm")},
                        {say("verification.U_mm", fmt::format("{:g}", coverage_factor))},
                        {say("verification.share")},
                        {say("verification.verdict_column"), ColumnKind::text}});
  for (const VerifiedRow& row : rows) {
    table.rows.push_back(cells_of(row, has_both, own_limits, say));
  }
  table.note = say("verification.tests_note");
  const bool any_unknown = std::any_of(rows.begin(), rows.end(), [](const VerifiedRow& row) {
    return row.judged.verdict != Verdict::not_judged && !claimed(row.judged.U_mm);
  });
  if (any_unknown) table.note = run_on({table.note, say("verification.no_U_note")}, say);
  if (has_both) table.note = run_on({table.note, say("verification.as_found_note")}, say);
  return table;
}

Table deciding_table(const std::vector<VerifiedRow>& rows, const Language& say) {
  Table table;
  table.caption = say("verification.decides");
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.decided_by"), ColumnKind::prose},
                   {say("verification.from"), ColumnKind::prose},
                   {say("verification.limit"), ColumnKind::word}};
  const auto add = [&](std::string title, const VerifiedRow& row, const VerifiedValue& value) {
    if (value.decided_by.empty()) return;
    const VerifiedPart* part = part_named(value);
    table.rows.push_back({{std::move(title)},
                          {value.decided_by},
                          {part == nullptr ? std::string() : part->where},
                          {row.limit}});
  };
  for (const VerifiedRow& row : rows) {
    if (!row.as_found) {
      add(row.title, row, row.judged);
      continue;
    }
    add(say("verification.title_of_test", row.title, say("verification.as_found")), row,
        *row.as_found);
    add(say("verification.title_of_test", row.title, say("verification.as_left")), row, row.judged);
  }
  return table;
}

Table parts_table(const std::vector<VerifiedRow>& rows, const Language& say) {
  const bool has_both = have_as_left(rows);
  Table table;
  table.columns = {{say("verification.test"), ColumnKind::prose},
                   {say("verification.part"), ColumnKind::text}};
  if (has_both) table.columns.push_back({say("verification.as_found_mm")});
  table.columns.push_back({say(has_both ? "verification.as_left_mm" : "verification.value_mm")});
  table.columns.push_back({say("verification.from"), ColumnKind::prose});
  table.shown = kShownParts;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (repeats_parts(rows, i)) continue;
    for (std::size_t part = 0; part < rows[i].judged.parts.size(); ++part) {
      table.rows.push_back(cells_of_part(rows[i], part, has_both));
    }
  }
  return table;
}

namespace {

std::string expansion_text(const DocumentView& artefact) {
  constexpr double kPerMillion = 1e6;
  return fmt::format("{} \u00b1 {}", fixed(kPerMillion * artefact.number("expansion_per_K"), 2),
                     fixed(kPerMillion * artefact.number("u_expansion_per_K"), 2));
}

std::vector<Cell> cells_of_certified(const DocumentView& artefact, std::string name,
                                     double certified_mm, double U_mm, const std::string& form) {
  return {{std::move(name)},
          {artefact.text_if("certificate").value_or("")},
          {mm_text(certified_mm, U_mm)},
          {fixed(micrometres_from_millimetres(U_mm), 2)},
          {fmt::format("{:g}", artefact.number("coverage_factor"))},
          {form},
          {expansion_text(artefact)}};
}

}  // namespace

Table artefacts_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("verification.artefacts");
  table.columns = {{say("verification.artefact"), ColumnKind::prose},
                   {say("verification.certificate"), ColumnKind::prose},
                   {say("verification.certified_mm")},
                   {say("verification.certified_U")},
                   {"k"},
                   {say("verification.certified_form")},
                   {say("verification.certified_expansion")}};
  table.shown = kShownParts;
  if (!document.has("artefacts")) return table;
  for (const DocumentView& artefact : document.list("artefacts")) {
    const std::string name = artefact.text("name");
    if (artefact.has("diameter_mm")) {
      table.rows.push_back(
          cells_of_certified(artefact, say("verification.sphere_named", name),
                             artefact.number("diameter_mm"), artefact.number("U_mm"),
                             fixed(micrometres_from_millimetres(artefact.number("form_mm")), 2)));
      continue;
    }
    for (const DocumentView& length : artefact.list("lengths")) {
      table.rows.push_back(
          cells_of_certified(artefact, say("verification.title_of_test", name, length.text("name")),
                             length.number("length_mm"), length.number("U_mm"), "\u2013"));
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
