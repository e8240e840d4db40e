// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/symmetric_point_tables.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/symmetric_point_values.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

Cell check_cell(const DocumentView& reading, const Language& say) {
  if (!is_checked_reading(reading)) return {say("symmetric.not_checked"), Tone::neutral};
  return is_flagged_reading(reading) ? Cell{say("symmetric.fails"), Tone::bad}
                                     : Cell{say("symmetric.holds"), Tone::good};
}

// What the reading would have to be, with its unit where the claim has another.
std::string mended_text(const DocumentView& claim) {
  const std::string text = amount_text(symmetric_amount(claim, "reconciled_by"), 3);
  const bool is_angle = claim.has("reconciled_by_deg");
  if (is_angle == (claim.text("unit") == "deg") || !symmetric_amount(claim, "reconciled_by"))
    return text;
  return fmt::format("{} {}", text, is_angle ? "deg" : "mm");
}

}  // namespace

Table symmetric_parameters(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("symmetric.parameters_caption");
  table.columns = {{say("parameters.name"), ColumnKind::text},
                   {say("parameters.nominal")},
                   {say("symmetric.chain")},
                   {"u"},
                   {say("symmetric.adjusted")},
                   {"u"},
                   {say("parameters.unit"), ColumnKind::word}};
  const DocumentView chain = document["chain"];
  const DocumentView chain_u = document["chain_u"];
  const DocumentView adjusted = document["adjusted"];
  for (const auto& [name, ignored] : adjusted.json().items()) {
    const DocumentView value = adjusted[name];
    const double u = value.number("u");
    const int decimals = decimals_for_uncertainty(u);
    std::vector<Cell> row = {
        {name}, {amount_text(value.number_if("nominal"), decimals)}, {"\u2013"}, {"\u2013"}};
    if (chain.has(name)) {
      const double u_chain = chain_u.number(name);
      const int places = decimals_for_uncertainty(u_chain);
      row[2].text = fixed(chain.number(name), places);
      row[3].text = fixed(u_chain, places);
    }
    row.push_back({fixed(value.number("value"), decimals)});
    row.push_back({fixed(u, decimals)});
    row.push_back({value.text("unit")});
    table.rows.push_back(std::move(row));
  }
  table.note = say("symmetric.parameters_note");
  return table;
}

Table symmetric_readings(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("symmetric.readings_caption");
  table.columns = {{say("symmetric.reading"), ColumnKind::text},
                   {say("symmetric.kind"), ColumnKind::text},
                   {say("symmetric.joint")},
                   {say("symmetric.value")},
                   {"u"},
                   {say("parameters.unit"), ColumnKind::word},
                   {say("symmetric.by_arm_file")},
                   {say("symmetric.predicted")},
                   {say("symmetric.residual")},
                   {say("symmetric.redundancy")},
                   {say("symmetric.detectable")},
                   {say("symmetric.check"), ColumnKind::text}};
  for (const DocumentView& reading : document.list("readings")) {
    const int decimals = decimals_of_reading(reading);
    const std::string kind = reading.text("kind");
    const std::string key = fmt::format("symmetric.kind_{}", kind);
    table.rows.push_back({{reading.text("name")},
                          {say.has(key) ? say(key) : kind},
                          {whole(reading.number("joint"))},
                          {fixed(reading.number("value"), decimals)},
                          {fixed(reading.number("u"), decimals)},
                          {reading.text("unit")},
                          {amount_text(reading.number_if("by_arm_file"), decimals)},
                          {amount_text(reading.number_if("predicted"), decimals)},
                          {amount_text(symmetric_amount(reading, "residual"), decimals)},
                          {amount_text(reading.number_if("redundancy"), 3)},
                          {amount_text(symmetric_amount(reading, "smallest_detectable"), decimals)},
                          check_cell(reading, say)});
  }
  table.note = document.has("power")
                   ? say("symmetric.readings_note_power", percent_text(document.number("power")),
                         percent_text(document.number("significance"), 1))
                   : say("symmetric.readings_note");
  return table;
}

Table symmetric_reductions(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("symmetric.reductions_caption");
  table.columns = {{say("symmetric.reading"), ColumnKind::text},
                   {say("symmetric.points_of")},
                   {say("symmetric.scatter")},
                   {say("symmetric.turned")},
                   {say("symmetric.slip")},
                   {say("symmetric.u_type_a")}};
  for (const DocumentView& reduction : document.list("reductions")) {
    std::vector<Cell> row = {{reduction.text("reading")}};
    if (reduction.has("end_a")) {
      const DocumentView a = reduction["end_a"];
      const DocumentView b = reduction["end_b"];
      row.push_back({fmt::format("{} + {}", whole(a.number("count")), whole(b.number("count")))});
      row.push_back({fmt::format("{} / {}", amount_text(a.number_if("s_mm"), 4),
                                 amount_text(b.number_if("s_mm"), 4))});
      row.push_back({fixed(reduction.number("half_turn_deg"), 3)});
      row.push_back({fixed(reduction.number("largest_slip_deg"), 4)});
    } else if (reduction.has("arc")) {
      row.push_back({whole(reduction["arc"].number("count"))});
      row.push_back({fixed(reduction["arc"].number("rms_mm"), 4)});
      row.insert(row.end(), {{"\u2013"}, {"\u2013"}});
    } else {
      const std::size_t settings =
          reduction.has("zero_search") ? reduction["zero_search"].list("settings").size() : 0;
      row.push_back({whole(static_cast<double>(settings))});
      row.insert(row.end(), {{"\u2013"}, {"\u2013"}, {"\u2013"}});
    }
    const bool is_angle = reduction.has("zero_search");
    row.push_back({is_angle
                       ? fmt::format("{} deg", fixed(reduction["zero_search"].number("u_deg"), 4))
                       : fmt::format("{} mm", fixed(reduction.number("u_type_a"), 4))});
    table.rows.push_back(std::move(row));
  }
  table.note = say("symmetric.reductions_note");
  return table;
}

std::optional<Table> symmetric_claims(const DocumentView& document, const Language& say) {
  const auto claims = document.list("claims");
  if (claims.empty()) return std::nullopt;
  Table table;
  table.caption = say("symmetric.claims_caption");
  table.columns = {{say("symmetric.claim"), ColumnKind::text},
                   {say("symmetric.claimed")},
                   {say("symmetric.readings_give")},
                   {say("symmetric.difference")},
                   {say("parameters.unit"), ColumnKind::word},
                   {say("symmetric.verdict"), ColumnKind::text},
                   {say("symmetric.contradicted_by"), ColumnKind::text},
                   {say("symmetric.reconciled_by")}};
  for (const DocumentView& claim : claims) {
    const bool agrees = claim.flag("agrees");
    const char* verdict = !agrees                      ? "symmetric.disagrees"
                          : claim.flag("sign_differs") ? "symmetric.agrees_but_sign"
                                                       : "symmetric.agrees";
    table.rows.push_back({{claim.text("name")},
                          {fixed(claim.number("claimed"), 3)},
                          {fixed(claim.number("value"), 3)},
                          {amount_text(symmetric_amount(claim, "difference"), 3)},
                          {claim.text("unit")},
                          {say(verdict), agrees ? Tone::good : Tone::bad},
                          {claim.text_if("contradicted_by").value_or("\u2013")},
                          {mended_text(claim)}});
  }
  return table;
}

}  // namespace armcal
