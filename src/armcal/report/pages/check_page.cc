// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/control_chart_figure.h"
#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"
#include "armcal/verification/drift.h"

namespace armcal {
namespace {

struct BrokenRule {
  std::string check;
  std::string words;
};

std::vector<BrokenRule> broken_rules(const DocumentView& trend, const Language& say) {
  std::vector<BrokenRule> rules;
  for (const DocumentView& each : trend.list("violations")) {
    const std::string side = each.text("side");
    if (side != "above" && side != "below") each["side"].complain("is neither above nor below");
    const std::string key = fmt::format("check.rule.{}_{}", whole(each.number("rule")), side);
    rules.push_back(
        {whole(each.number("check")), say.has(key) ? say(key) : each.text("description")});
  }
  return rules;
}

// Rules that the last check breaks.
std::size_t broken_now(const DocumentView& document, const Language& say) {
  std::size_t count = 0;
  for (const DocumentView& trend : document.list("trends")) {
    const TrendHistory history = trend_history(trend, say);
    if (history.checks.empty()) continue;
    for (const BrokenRule& each : broken_rules(trend, say)) {
      if (each.check == history.checks.back().number) ++count;
    }
  }
  return count;
}

bool exceeds_at_last(const TrendHistory& history) {
  return history.limit_mm && !history.checks.empty() &&
         std::abs(history.checks.back().value_mm) > *history.limit_mm;
}

// Does the last check exceed its limit?
bool exceeds_now(const DocumentView& document, const Language& say) {
  const std::vector<DocumentView> trends = document.list("trends");
  return std::any_of(trends.begin(), trends.end(), [&](const DocumentView& trend) {
    return exceeds_at_last(trend_history(trend, say));
  });
}

bool has_check(const DocumentView& document) { return document.has("tests"); }

Stamp check_stamp(const DocumentView& document, const Language& say) {
  const std::size_t broken = broken_now(document, say);
  const std::string unusual = say("check.sentence.unusual");
  if (!has_check(document)) {
    if (exceeds_now(document, say)) {
      return {say("check.stamp.exceeds"), say("check.sentence.exceeded"), Tone::bad};
    }
    if (broken == 0) return {say("check.stamp.usual"), say("check.sentence.usual"), Tone::good};
    return {say("check.stamp.unusual"), unusual, Tone::warning};
  }
  const Verdict verdict = verdict_in(document);
  std::vector<std::string> sentences = {say(fmt::format("check.sentence.{}", to_string(verdict)))};
  if (broken > 0) sentences.push_back(unusual);
  Stamp stamp{say(fmt::format("check.stamp.{}", to_string(verdict))), run_on(sentences, say),
              tone_of(verdict)};
  if (broken > 0 && verdict != Verdict::fail) stamp.tone = Tone::warning;
  return stamp;
}

std::string signed_mm(double value_mm) {
  return fmt::format("{}{}", value_mm < 0.0 ? "" : "+", fixed(value_mm, 4));
}

void add_drifts(const DocumentView& document, const Language& say, Headlines& headlines) {
  for (const DocumentView& trend : document.list("trends")) {
    const TrendHistory history = trend_history(trend, say);
    if (!history.drift) continue;
    const TrendDrift& drift = *history.drift;
    headlines.items.push_back(
        {say("check.drift_of", history.title), signed_mm(kMonth_days * drift.mm_per_day), "mm",
         say(drift.is_significant ? "check.drift_note" : "check.drift_by_chance",
             fixed(kMonth_days * drift.u_mm_per_day, 4)),
         drift.is_significant ? Tone::warning : Tone::neutral});
  }
}

Headlines check_headlines(const DocumentView& document, const Language& say) {
  Headlines headlines;
  const auto tests = has_check(document) ? document.list("tests") : std::vector<DocumentView>();
  for (const DocumentView& test : tests) {
    const auto limit = test.number_if("mpe_mm");
    if (!limit) continue;
    headlines.items.push_back({title_of_check_value(test.text("name"), say),
                               mm_text(test.number("value_mm")), "mm",
                               say("check.limit_note", mm_text(limit)), tone_of(verdict_in(test))});
  }
  add_drifts(document, say, headlines);
  return headlines;
}

Table check_tests_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("check.tests");
  table.columns = {{say("check.quantity"), ColumnKind::text},
                   {say("verification.value_mm")},
                   {say("check.limit_mm")},
                   {say("check.share")},
                   {say("verification.verdict_column"), ColumnKind::text}};
  for (const DocumentView& test : document.list("tests")) {
    const double value = test.number("value_mm");
    const auto limit = test.number_if("mpe_mm");
    const auto share =
        limit && *limit > 0.0 ? std::optional(std::abs(value) / *limit) : std::nullopt;
    table.rows.push_back({{title_of_check_value(test.text("name"), say)},
                          {mm_text(value)},
                          {mm_text(limit)},
                          {percent_text(share)},
                          verdict_cell(verdict_in(test), say)});
  }
  table.note = say("check.tests_note");
  return table;
}

Section check_definitions_section(const DocumentView& document, const Language& say) {
  Table table;
  table.columns = {{say("check.quantity"), ColumnKind::text},
                   {say("check.definition"), ColumnKind::prose}};
  for (const DocumentView& test : document.list("tests")) {
    table.rows.push_back({{title_of_check_value(test.text("name"), say)},
                          {in_language(test.text("definition"), "check.phrase", say)}});
  }
  return {"definitions", say("verification.definitions"), "", {table}};
}

Table check_places_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("check.places");
  table.columns = {{say("check.place"), ColumnKind::text},
                   {say("check.points")},
                   {"x, mm"},
                   {"y, mm"},
                   {"z, mm"}};
  for (const DocumentView& place : document.list("places")) {
    std::vector<Cell> cells = {{place.text("name")}, {whole(place.number("count"))}};
    for (const double each : place.numbers("center_mm")) cells.push_back({mm_text(each)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

// Of a history that was only looked at.
Table last_values_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("check.last_values");
  table.columns = {{say("check.quantity"), ColumnKind::text},
                   {say("verification.value_mm")},
                   {say("check.limit_mm")},
                   {say("check.check")},
                   {say("check.date"), ColumnKind::word}};
  for (const DocumentView& trend : document.list("trends")) {
    const TrendHistory history = trend_history(trend, say);
    if (history.checks.empty()) continue;
    const TrendCheck& last = history.checks.back();
    table.rows.push_back(
        {{history.title},
         {mm_text(last.value_mm), exceeds_at_last(history) ? Tone::bad : Tone::neutral},
         {mm_text(history.limit_mm)},
         {last.number},
         {last.time.substr(0, 10)}});
  }
  return table;
}

Section check_summary_section(const DocumentView& document, const Language& say) {
  Section section{"summary", say("verification.summary"), "", {}};
  Headlines headlines = check_headlines(document, say);
  if (!headlines.items.empty()) section.blocks.emplace_back(std::move(headlines));
  if (!has_check(document)) {
    section.blocks.emplace_back(Paragraph{say("check.history_only")});
    section.blocks.emplace_back(last_values_table(document, say));
    return section;
  }
  section.blocks.push_back(check_tests_table(document, say));
  section.blocks.push_back(check_places_table(document, say));
  return section;
}

std::string drift_text(const TrendDrift& drift) {
  return fmt::format("{} mm (u = {} mm)", signed_mm(kMonth_days * drift.mm_per_day),
                     fixed(kMonth_days * drift.u_mm_per_day, 4));
}

std::string drift_sentence(const TrendHistory& trend, const Language& say) {
  if (!trend.drift) return say("check.no_drift_yet");
  const TrendDrift& drift = *trend.drift;
  if (!drift.is_significant) return say("check.no_drift", drift_text(drift));
  if (!drift.days_to_limit) return say("check.drifts", drift_text(drift));
  return say("check.drifts_to_limit", drift_text(drift), fixed(*drift.days_to_limit, 0));
}

Notice drift_notice(const TrendHistory& trend, const Language& say) {
  const bool drifts = trend.drift && trend.drift->is_significant;
  return {drifts ? Tone::warning : Tone::neutral, "", {drift_sentence(trend, say)}};
}

Table rules_table(const DocumentView& trend, const Language& say) {
  Table table;
  table.caption = say("check.broken_rules");
  table.columns = {{say("check.check"), ColumnKind::word},
                   {say("check.date"), ColumnKind::word},
                   {say("check.rule_column"), ColumnKind::prose}};
  const TrendHistory history = trend_history(trend, say);
  for (const BrokenRule& rule : broken_rules(trend, say)) {
    const auto at = std::find_if(history.checks.begin(), history.checks.end(),
                                 [&](const TrendCheck& each) { return each.number == rule.check; });
    table.rows.push_back({{rule.check},
                          {at == history.checks.end() ? std::string() : at->time.substr(0, 10)},
                          {rule.words}});
  }
  table.note = say("check.rules_note");
  return table;
}

Table history_table(const TrendHistory& trend, const Language& say) {
  constexpr std::size_t kShown = 8;
  Table table;
  table.caption = say("check.history");
  table.columns = {{say("check.check"), ColumnKind::word},
                   {say("check.date"), ColumnKind::word},
                   {say("verification.value_mm")}};
  for (auto each = trend.checks.rbegin(); each != trend.checks.rend(); ++each) {
    table.rows.push_back(
        {{each->number},
         {each->time.substr(0, 10)},
         {mm_text(each->value_mm), each->breaks_a_rule ? Tone::warning : Tone::neutral}});
  }
  table.shown = kShown;
  return table;
}

Section trend_section(const DocumentView& trend, std::size_t number, const Language& say) {
  const TrendHistory history = trend_history(trend, say);
  Section section{fmt::format("trend-of-{}", number), say("check.trend_of", history.title), "", {}};
  section.blocks.push_back(Figures{{control_chart_figure(history, number, say)}});
  section.blocks.push_back(drift_notice(history, say));
  Table rules = rules_table(trend, say);
  if (!rules.rows.empty()) section.blocks.emplace_back(std::move(rules));
  section.blocks.push_back(history_table(history, say));
  return section;
}

Facts head_of(const DocumentView& document, const Language& say) {
  Facts head{{{say("check.arm"), document.text("arm_name")},
              {say("check.artefact"), document.text("artefact")},
              {say("check.time"), document.text_if("time").value_or("")},
              {say("check.history_file"), document.text_if("history").value_or("")}}};
  if (const auto saved = document.number_if("saved_as")) {
    head.rows.emplace_back(say("check.saved_as"), whole(*saved));
  }
  const auto add_mm = [&](const char* label, const char* key) {
    const auto value = document.number_if(key);
    if (!value || *value == 0.0) return;
    head.rows.emplace_back(say(label), fmt::format("{} mm", mm_text(value)));
  };
  add_mm("check.certified_diameter", "diameter_mm");
  add_mm("check.tip_diameter", "tip_diameter_mm");
  add_mm("check.certified_length", "length_mm");
  if (const auto temperature = document.number_if("temperature_C")) {
    head.rows.emplace_back(say("check.temperature"), fmt::format("{:g} \u00b0C", *temperature));
  }
  head.rows.emplace_back(say("check.note"), document.text_if("note").value_or(""));
  return head;
}

}  // namespace

Page check_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("check.title");
  page.subtitle = document.text("arm_name");
  page.head = head_of(document, say);
  page.stamp = check_stamp(document, say);
  page.sections.push_back(check_summary_section(document, say));
  const std::vector<DocumentView> trends = document.list("trends");
  for (std::size_t i = 0; i < trends.size(); ++i) {
    page.sections.push_back(trend_section(trends[i], i + 1, say));
  }
  if (trends.empty()) {
    page.sections.push_back(
        {"history", say("check.history"), "", {Paragraph{say("check.no_history")}}});
  }
  if (has_check(document)) page.sections.push_back(check_definitions_section(document, say));
  return page;
}

}  // namespace armcal
