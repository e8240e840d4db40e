// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/symmetric_point_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "armcal/report/chart/heat_map.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/arm_of.h"
#include "armcal/report/pages/posture_figures.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

// A number whose key says its unit: residual_mm or residual_deg.
std::optional<double> amount_if(const DocumentView& entry, const std::string& key) {
  for (const char* unit : {"_mm", "_deg"}) {
    if (const auto value = entry.number_if(key + unit)) return value;
  }
  return std::nullopt;
}

std::string text_if(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : "\u2013";
}

int decimals_of(const DocumentView& reading) {
  return decimals_for_uncertainty(reading.number("u"));
}

bool is_checked(const DocumentView& reading) { return reading.has("normalised"); }

bool is_flagged(const DocumentView& reading) {
  return reading.has("flagged") && reading.flag("flagged");
}

std::string joined(const std::vector<std::string>& names, const Language& say,
                   const char* separator = "calibration.name_separator") {
  std::string text;
  for (const std::string& name : names) {
    text += fmt::format("{}{}", text.empty() ? "" : say(separator), name);
  }
  return text;
}

Stamp symmetric_stamp(const DocumentView& document, const Language& say) {
  if (document.flag("consistent")) {
    const auto readings = document.list("readings");
    if (std::none_of(readings.begin(), readings.end(), is_checked)) {
      return {say("symmetric.unproven"), say("symmetric.unproven_sentence"), Tone::warning};
    }
    std::vector<std::string> sentences = {say("symmetric.consistent_sentence")};
    if (!document.list("claims").empty()) sentences.push_back(say("symmetric.claims_agree"));
    return {say("symmetric.consistent"), run_on(sentences, say), Tone::good};
  }
  return {say("symmetric.contradicted"), say("symmetric.contradicted_sentence"), Tone::bad};
}

// Readings that fail, each with those that it cannot be told apart from.
std::vector<std::vector<DocumentView>> failing_groups(const DocumentView& document) {
  const std::vector<DocumentView> readings = document.list("readings");
  std::set<std::string> told;
  std::vector<std::vector<DocumentView>> groups;
  for (const DocumentView& reading : readings) {
    if (!is_flagged(reading) || told.contains(reading.text("name"))) continue;
    std::vector<std::string> names = reading.texts("inseparable_from");
    names.push_back(reading.text("name"));
    std::vector<DocumentView> group;
    for (const DocumentView& each : readings) {
      if (std::find(names.begin(), names.end(), each.text("name")) == names.end()) continue;
      told.insert(each.text("name"));
      group.push_back(each);
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

Headlines symmetric_headlines(const DocumentView& document, const Language& say) {
  const auto readings = document.list("readings");
  const auto checked = std::count_if(readings.begin(), readings.end(), is_checked);
  const std::size_t failing = failing_groups(document).size();
  const auto claims = document.list("claims");
  const auto wrong = std::count_if(claims.begin(), claims.end(),
                                   [](const DocumentView& claim) { return !claim.flag("agrees"); });
  Headlines headlines;
  headlines.items = {
      {say("symmetric.readings"), whole(static_cast<double>(readings.size())), "",
       say("symmetric.checked_note", checked, whole(document.number("dof"))), Tone::neutral},
      {say("symmetric.parameters"), whole(document.number("rank")), "",
       say("symmetric.condition_note", condition_text(document.number_if("condition_number"))),
       Tone::neutral},
      {say("symmetric.chi2"), fixed(document.number("chi2"), 2), "",
       say("symmetric.chi2_note", whole(document.number("dof")),
           fmt::format("{:.2g}", document.number("chi2_probability"))),
       Tone::neutral},
      {say("symmetric.flagged"), fmt::format("{}", failing), "", say("symmetric.flagged_note"),
       failing > 0 ? Tone::bad : Tone::neutral}};
  if (!claims.empty()) {
    headlines.items.push_back({say("symmetric.claims_wrong"), fmt::format("{}", wrong), "",
                               say("symmetric.claims_note", claims.size()),
                               wrong > 0 ? Tone::bad : Tone::neutral});
  }
  return headlines;
}

// The document names a length of the same size as "the reading R", "half of R" or "b7 as adjusted".
std::string said_length(const std::string& name, const Language& say) {
  constexpr std::string_view kReading = "the reading ";
  constexpr std::string_view kHalf = "half of ";
  constexpr std::string_view kAdjusted = " as adjusted";
  if (name.starts_with(kReading)) {
    return say("symmetric.equals_reading", name.substr(kReading.size()));
  }
  if (name.starts_with(kHalf)) return say("symmetric.equals_half", name.substr(kHalf.size()));
  if (name.ends_with(kAdjusted)) {
    return say("symmetric.equals_adjusted", name.substr(0, name.size() - kAdjusted.size()));
  }
  return name;
}

// How far an arm that was held against the readings misses them.
void add_compared_arm(const DocumentView& document, const Language& say,
                      std::vector<std::string>& found) {
  if (!document.has("compared_arm")) return;
  double worst = 0.0;
  std::string at;
  for (const DocumentView& reading : document.list("readings")) {
    const auto other = reading.number_if("by_compared_arm");
    if (!other || reading.text("unit") != "mm") continue;
    const double miss = std::abs(*other - reading.number("value"));
    if (miss <= worst) continue;
    worst = miss;
    at = reading.text("name");
  }
  found.push_back(
      say("symmetric.compared_misses", document.text("compared_arm"), fixed(worst, 3), at));
}

void add_signs(const DocumentView& document, const Language& say, std::vector<std::string>& found) {
  const std::vector<DocumentView> signs = document.list("signs");
  if (signs.size() < 2) return;
  const auto good = static_cast<std::size_t>(
      document.ordinal("equally_good_signs", static_cast<int>(signs.size())));
  std::vector<std::string> best;
  for (std::size_t i = 0; i < good; ++i) {
    const std::vector<std::string> turned = signs[i].texts("turned");
    best.push_back(turned.empty() ? say("symmetric.signs_as_drawn")
                                  : say("symmetric.signs_turned", joined(turned, say)));
  }
  std::string sentence = say(good == 1 ? "symmetric.signs_one" : "symmetric.signs_several",
                             signs.size(), good, joined(best, say, "symmetric.signs_separator"));
  const double misfit = signs[0].number_if("misfit").value_or(0.0);
  const auto next = good < signs.size() ? signs[good].number_if("misfit") : std::nullopt;
  if (next && misfit > 0.0) sentence += say("symmetric.signs_next", fixed(*next / misfit, 0));
  found.push_back(std::move(sentence));
}

void add_claims(const DocumentView& document, const Language& say,
                std::vector<std::string>& found) {
  for (const DocumentView& claim : document.list("claims")) {
    if (claim.flag("agrees")) continue;
    const std::string claimed = fixed(claim.number("claimed"), 3);
    const auto culprit = claim.text_if("contradicted_by");
    const auto mended = amount_if(claim, "reconciled_by");
    if (culprit && mended) {
      found.push_back(say("symmetric.claim_against_reading", claim.text("name"), claimed, *culprit,
                          fixed(*mended, 3)));
    } else {
      found.push_back(say("symmetric.claim_against_all", claim.text("name"), claimed,
                          fixed(claim.number("value"), 3)));
    }
    std::vector<std::string> equals;
    for (const std::string& same : claim.texts("equals")) equals.push_back(said_length(same, say));
    if (!equals.empty()) found.back() += say("symmetric.claim_equals", joined(equals, say));
  }
}

void add_failures(const DocumentView& document, const Language& say,
                  std::vector<std::string>& found) {
  const std::string limit = fixed(document.number("critical_value"), 2);
  for (const std::vector<DocumentView>& group : failing_groups(document)) {
    std::vector<std::string> names;
    std::vector<std::string> changes;
    for (const DocumentView& reading : group) {
      names.push_back(reading.text("name"));
      changes.push_back(say("symmetric.would_change", names.back(),
                            text_if(amount_if(reading, "estimated_error"), 3),
                            reading.text("unit")));
    }
    const DocumentView& first = group.front();
    const std::string normalised = fixed(std::abs(first.number("normalised")), 1);
    if (group.size() > 1) {
      found.push_back(say("symmetric.group_fails", joined(names, say), normalised, limit,
                          joined(changes, say)));
    } else {
      found.push_back(say("symmetric.reading_fails", names.front(),
                          text_if(amount_if(first, "estimated_error"), 3), first.text("unit"),
                          normalised, limit));
    }
  }
}

// What a reader has to know, one sentence each: as `findings` of the text report, in any language.
std::vector<std::string> findings_of(const DocumentView& document, const Language& say) {
  std::vector<std::string> found;
  add_compared_arm(document, say, found);
  add_signs(document, say, found);
  if (document.has("chain_problem")) {
    found.push_back(say("symmetric.chain_breaks", document.text("chain_problem")));
  }
  add_claims(document, say, found);
  add_failures(document, say, found);
  std::vector<std::string> unchecked;
  for (const DocumentView& reading : document.list("readings")) {
    if (reading.has("redundancy") && !is_checked(reading)) {
      unchecked.push_back(reading.text("name"));
    }
  }
  if (!unchecked.empty()) found.push_back(say("symmetric.unchecked", joined(unchecked, say)));
  std::vector<std::string> held;
  for (const DocumentView& each : document.list("undetermined")) held.push_back(each.text("name"));
  if (!held.empty()) found.push_back(say("symmetric.undetermined", joined(held, say)));
  return found;
}

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
        {name}, {text_if(value.number_if("nominal"), decimals)}, {"\u2013"}, {"\u2013"}};
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

Cell check_cell(const DocumentView& reading, const Language& say) {
  if (!is_checked(reading)) return {say("symmetric.not_checked"), Tone::neutral};
  return is_flagged(reading) ? Cell{say("symmetric.fails"), Tone::bad}
                             : Cell{say("symmetric.holds"), Tone::good};
}

Table readings_of(const DocumentView& document, const Language& say) {
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
    const int decimals = decimals_of(reading);
    const std::string kind = reading.text("kind");
    const std::string key = fmt::format("symmetric.kind_{}", kind);
    table.rows.push_back({{reading.text("name")},
                          {say.has(key) ? say(key) : kind},
                          {whole(reading.number("joint"))},
                          {fixed(reading.number("value"), decimals)},
                          {fixed(reading.number("u"), decimals)},
                          {reading.text("unit")},
                          {text_if(reading.number_if("by_arm_file"), decimals)},
                          {text_if(reading.number_if("predicted"), decimals)},
                          {text_if(amount_if(reading, "residual"), decimals)},
                          {text_if(reading.number_if("redundancy"), 3)},
                          {text_if(amount_if(reading, "smallest_detectable"), decimals)},
                          check_cell(reading, say)});
  }
  table.note = document.has("power")
                   ? say("symmetric.readings_note_power", percent_text(document.number("power")),
                         percent_text(document.number("significance"), 1))
                   : say("symmetric.readings_note");
  return table;
}

// Where a reading came as points: what its two ends, its arc or its search gave.
Table reductions_of(const DocumentView& document, const Language& say) {
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
      row.push_back({fmt::format("{} / {}", text_if(a.number_if("s_mm"), 4),
                                 text_if(b.number_if("s_mm"), 4))});
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

// What the reading would have to be, with its unit where the claim has another.
std::string mended_text(const DocumentView& claim) {
  const std::string text = text_if(amount_if(claim, "reconciled_by"), 3);
  const bool is_angle = claim.has("reconciled_by_deg");
  if (is_angle == (claim.text("unit") == "deg") || !amount_if(claim, "reconciled_by")) return text;
  return fmt::format("{} {}", text, is_angle ? "deg" : "mm");
}

std::optional<Table> claims_of(const DocumentView& document, const Language& say) {
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
                          {text_if(amount_if(claim, "difference"), 3)},
                          {claim.text("unit")},
                          {say(verdict), agrees ? Tone::good : Tone::bad},
                          {claim.text_if("contradicted_by").value_or("\u2013")},
                          {mended_text(claim)}});
  }
  return table;
}

bool is_angle(const std::string& parameter) {
  return parameter.rfind("zero", 0) == 0 || parameter.rfind("alpha", 0) == 0 ||
         parameter.rfind("beta", 0) == 0 || parameter.rfind("cos", 0) == 0 ||
         parameter.rfind("sin", 0) == 0;
}

// Errors of recovered parameters where an assumption is wrong by 1 mm or 1 mrad, in mm or mrad.
// Assumptions that shift nothing have no column.
std::optional<Figure> leakage_of(const DocumentView& document, const Language& say) {
  constexpr double kNothing = 1e-3;
  constexpr double kLeastMarked = 0.02;
  const std::vector<std::string> recovered = document.texts("leakage_rows");
  const std::vector<std::string> assumed = document.texts("leakage_columns");
  const auto rows = document.list("leakage");
  if (rows.size() != recovered.size()) {
    document["leakage"].complain("has not as many rows as leakage_rows has names");
  }
  if (recovered.empty()) return std::nullopt;
  Eigen::MatrixXd values(static_cast<Eigen::Index>(recovered.size()),
                         static_cast<Eigen::Index>(assumed.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<double> numbers = rows[r].as_numbers();
    if (numbers.size() != assumed.size()) rows[r].complain("has another length");
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      const double scale =
          (is_angle(assumed[c]) ? 1e-3 : 1.0) * (is_angle(recovered[r]) ? 1e3 : 1.0);
      values(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = scale * numbers[c];
    }
  }
  HeatMap map;
  map.id = "leakage-map";
  map.title = say("symmetric.leakage");
  map.text = say(document.text("leakage_of") == "chain" ? "symmetric.leakage_of_chain"
                                                        : "symmetric.leakage_of_adjustment");
  map.text += say("symmetric.leakage_marked", 100.0 * kLeastMarked);
  map.least_marked = kLeastMarked;
  map.nothing = say("symmetric.no_leakage");
  map.key_label = say("symmetric.leakage_key");
  map.rows = recovered;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    if (values.col(c).cwiseAbs().maxCoeff() < kNothing) continue;
    kept.push_back(c);
    map.columns.push_back(assumed[static_cast<std::size_t>(c)]);
  }
  map.values = values(Eigen::all, kept);
  return figure_of(map);
}

Figures postures_of(const DocumentView& document, const Language& say) {
  std::vector<PostureReading> readings;
  for (const DocumentView& reading : document.list("readings")) {
    const std::string value = fmt::format(
        "{} {}", fixed(reading.number("value"), decimals_of(reading)), reading.text("unit"));
    readings.push_back({reading, value});
  }
  return posture_figures(
      arm_of(document, document.has("adjusted_arm") ? "adjusted_arm" : "nominal_arm"), readings,
      say);
}

Section result_section(const DocumentView& document, const Language& say) {
  Section section{"summary", say("calibration.summary"), "", {symmetric_headlines(document, say)}};
  const std::vector<std::string> findings = findings_of(document, say);
  if (!findings.empty()) {
    section.blocks.emplace_back(Notice{document.flag("consistent") ? Tone::neutral : Tone::warning,
                                       say("symmetric.findings"), findings});
  }
  return section;
}

}  // namespace

Page symmetric_point_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("symmetric.title");
  page.subtitle = document.text("arm");
  page.stamp = symmetric_stamp(document, say);
  page.sections.push_back(result_section(document, say));
  page.sections.push_back({"parameters",
                           say("symmetric.chain_and_adjustment"),
                           say("symmetric.chain_lead"),
                           {symmetric_parameters(document, say)}});
  if (auto claims = claims_of(document, say)) {
    page.sections.push_back(
        {"claims", say("symmetric.claims"), say("symmetric.claims_lead"), {std::move(*claims)}});
  }
  page.sections.push_back(
      {"readings", say("symmetric.readings"), "", {readings_of(document, say)}});
  if (!document.list("reductions").empty()) {
    page.sections.back().blocks.emplace_back(reductions_of(document, say));
  }
  if (document.has("nominal_arm")) {
    page.sections.push_back({"postures",
                             say("symmetric.postures"),
                             say("symmetric.postures_lead"),
                             {postures_of(document, say)}});
  }
  if (auto leakage = leakage_of(document, say)) {
    page.sections.push_back({"leakage",
                             say("symmetric.leakage_title"),
                             say("symmetric.leakage_lead"),
                             {Figures{{std::move(*leakage)}}}});
  }
  return page;
}

}  // namespace armcal
