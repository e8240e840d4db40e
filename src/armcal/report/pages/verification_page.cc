// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/verification_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/phrase_book.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/pages/verification_budgets.h"
#include "armcal/report/pages/verification_figures.h"
#include "armcal/report/pages/verification_tables.h"
#include "armcal/report/pages/verification_values.h"

namespace armcal {
namespace {

constexpr std::array kRules = {"iso14253-1", "conformance-probability", "simple-acceptance",
                               "guard-band"};

struct Tally {
  std::size_t judged = 0, passed = 0, failed = 0, undecided = 0, incomplete = 0;
};

Tally tally_of(const std::vector<VerifiedRow>& rows) {
  Tally tally;
  for (const VerifiedRow& row : rows) {
    const Verdict verdict = row.judged.verdict;
    if (verdict != Verdict::not_judged) ++tally.judged;
    if (verdict == Verdict::pass) ++tally.passed;
    if (verdict == Verdict::fail) ++tally.failed;
    if (verdict == Verdict::undecided) ++tally.undecided;
    if (!row.judged.is_complete) ++tally.incomplete;
  }
  return tally;
}

Stamp verification_stamp(const DocumentView& document, const std::vector<VerifiedRow>& rows,
                         const Language& say) {
  const Verdict verdict = verdict_in(document);
  const Tally tally = tally_of(rows);
  const std::size_t count = verdict == Verdict::fail        ? tally.failed
                            : verdict == Verdict::undecided ? tally.undecided
                                                            : tally.passed;
  std::vector<std::string> sentences = {
      say(fmt::format("verification.sentence.{}", to_string(verdict)), count, rows.size())};
  if (document.has("as_found_verdict")) {
    sentences.push_back(say("verification.sentence.as_found",
                            word_of(verdict_in(document, "as_found_verdict"), say)));
  }
  if (tally.incomplete > 0) {
    sentences.push_back(say("verification.sentence.incomplete", tally.incomplete, rows.size()));
  }
  Stamp stamp = armcal::stamp_of(verdict, run_on(sentences, say), say);
  if (tally.incomplete > 0) stamp.word = say("verification.stamp.incomplete", stamp.word);
  // What passes but is no test of the standard is no plain pass.
  if (tally.incomplete > 0 && verdict == Verdict::pass) stamp.tone = Tone::warning;
  return stamp;
}

struct Nearest {
  const VerifiedRow* row = nullptr;
  double share = 0.0;
  Verdict verdict = Verdict::not_judged;
};

// The statistic that takes the largest share of its limit.
template <typename ValueOf>
Nearest nearest_of(const std::vector<VerifiedRow>& rows, const ValueOf& value_of) {
  Nearest nearest;
  for (const VerifiedRow& row : rows) {
    const VerifiedValue* value = value_of(row);
    if (value == nullptr || !value->share_of_mpe) continue;
    if (nearest.row != nullptr && *value->share_of_mpe <= nearest.share) continue;
    nearest = {&row, *value->share_of_mpe, value->verdict};
  }
  return nearest;
}

void add_share(const Nearest& nearest, const char* label, const Language& say,
               Headlines& headlines) {
  if (nearest.row == nullptr) return;
  headlines.items.push_back({say(label), percent_text(nearest.share), "%",
                             say("verification.share_note", nearest.row->title),
                             tone_of(nearest.verdict)});
}

void add_probability(const std::vector<VerifiedRow>& rows, const Language& say,
                     Headlines& headlines) {
  const VerifiedRow* least = nullptr;
  for (const VerifiedRow& row : rows) {
    const auto& probability = row.judged.conformance_probability;
    // Without an uncertainty it would be claimed to be certain.
    if (!probability || row.judged.U_mm.value_or(0.0) <= 0.0) continue;
    if (least == nullptr || *probability < *least->judged.conformance_probability) least = &row;
  }
  if (least == nullptr) return;
  constexpr double kAsGoodAsCertain = 0.999;
  const double probability = *least->judged.conformance_probability;
  std::string text = percent_text(probability, 1);
  if (probability > kAsGoodAsCertain) text = fmt::format("> {}", percent_text(kAsGoodAsCertain, 1));
  if (probability < 1.0 - kAsGoodAsCertain) {
    text = fmt::format("< {}", percent_text(1.0 - kAsGoodAsCertain, 1));
  }
  headlines.items.push_back({say("verification.probability"), text, "%",
                             say("verification.probability_note", least->title), Tone::neutral});
}

Headlines verification_headlines(const std::vector<VerifiedRow>& rows, const DocumentView& document,
                                 const Language& say) {
  Headlines headlines;
  const Tally tally = tally_of(rows);
  headlines.items.push_back(
      {say("verification.tests_passed"), fmt::format("{} / {}", tally.passed, tally.judged), "",
       tally.judged == 0 ? say("verification.no_limits")
                         : say("verification.tests_passed_note", tally.failed, tally.undecided),
       tone_of(verdict_in(document))});
  const bool has_both = document.has("as_found_verdict");
  if (has_both) {
    add_share(
        nearest_of(rows,
                   [](const VerifiedRow& row) { return row.as_found ? &*row.as_found : nullptr; }),
        "verification.largest_share_as_found", say, headlines);
  }
  add_share(nearest_of(rows, [](const VerifiedRow& row) { return &row.judged; }),
            has_both ? "verification.largest_share_as_left" : "verification.largest_share", say,
            headlines);
  add_probability(rows, say, headlines);
  return headlines;
}

Notice incomplete_notice(const std::vector<VerifiedRow>& rows, const Language& say) {
  Notice notice{Tone::warning, say("verification.incomplete"), {}};
  // Statistics of one test share what it lacks.
  std::set<std::pair<std::string, std::string>> told;
  for (const VerifiedRow& row : rows) {
    for (const std::string& missing : row.judged.missing) {
      if (!told.emplace(row.test, missing).second) continue;
      notice.lines.push_back(say("verification.missing", row.title, missing));
    }
  }
  return notice;
}

// A part of the standard is not the standard.
Notice not_performed_notice(const DocumentView& document, const Language& say) {
  Notice notice{Tone::warning, say("verification.not_performed"), {}};
  if (!document.has("not_performed")) return notice;
  for (const std::string& each : document.texts("not_performed")) {
    notice.lines.push_back(in_language(each, kVerificationPhrases, say));
  }
  return notice;
}

std::string rule_in_words(const DocumentView& decision, const Language& say) {
  const std::string rule = decision.text("rule");
  if (std::find(kRules.begin(), kRules.end(), rule) == kRules.end()) {
    decision["rule"].complain("is no decision rule of this armcal");
  }
  return say(fmt::format("verification.rule.{}", rule),
             fmt::format("{:g}", decision.number("coverage_factor")),
             percent_text(decision.number_if("probability"), 1),
             fmt::format("{:g}", decision.number_if("guard_factor").value_or(1.0)));
}

Facts basis_of(const DocumentView& document, const Language& say) {
  const std::string own = say("verification.own_software");
  Facts facts;
  facts.rows = {{say("verification.standard"), document.text("standard")}};
  if (const auto left = document.text_if("as_left_arm")) {
    facts.rows.emplace_back(say("verification.arm_as_found"),
                            document.text_if("arm").value_or(own));
    facts.rows.emplace_back(say("verification.arm_as_left"), *left);
  } else {
    facts.rows.emplace_back(say("verification.arm"), document.text_if("arm").value_or(own));
  }
  if (const auto reach = document.number_if("reach_mm")) {
    facts.rows.emplace_back(say("verification.reach"), fmt::format("{} mm", fixed(*reach, 1)));
  }
  const double k = document["decision"].number("coverage_factor");
  facts.rows.emplace_back(say("verification.coverage_factor"), fmt::format("k = {:g}", k));
  return facts;
}

Section verification_summary_section(const DocumentView& document,
                                     const std::vector<VerifiedRow>& rows, const Language& say) {
  Section section{"summary", say("verification.summary"), "", {}};
  section.blocks.push_back(verification_headlines(rows, document, say));
  Notice incomplete = incomplete_notice(rows, say);
  if (!incomplete.lines.empty()) section.blocks.emplace_back(std::move(incomplete));
  Notice absent = not_performed_notice(document, say);
  if (!absent.lines.empty()) section.blocks.emplace_back(std::move(absent));
  const double k = document["decision"].number("coverage_factor");
  section.blocks.push_back(tests_table(rows, have_as_left(rows), k, say));
  return section;
}

Section judgement_section(const DocumentView& document, const std::vector<VerifiedRow>& rows,
                          const Language& say) {
  Section section{"judgement",
                  say("verification.judgement"),
                  say("verification.decided_so", rule_in_words(document["decision"], say)),
                  {}};
  section.blocks.push_back(basis_of(document, say));
  section.blocks.push_back(Figures{{limit_figure(rows, document["decision"].text("rule"), say)}});
  Table deciding = deciding_table(rows, say);
  if (!deciding.rows.empty()) section.blocks.emplace_back(std::move(deciding));
  return section;
}

std::optional<Section> artefacts_section(const DocumentView& document, const Language& say) {
  Table artefacts = artefacts_table(document, say);
  if (artefacts.rows.empty()) return std::nullopt;
  Section section{"artefacts", say("verification.artefacts_title"), "", {std::move(artefacts)}};
  const DocumentView environment = document["environment"];
  section.lead = say("verification.temperature", fixed(environment.number("temperature_C"), 1),
                     fixed(environment.number("u_temperature_K"), 2));
  return section;
}

std::optional<Section> values_section(const std::vector<VerifiedRow>& rows, const Language& say) {
  Section section{"values", say("verification.values"), say("verification.values_lead"), {}};
  Figures figures = part_figures(rows, say);
  if (!figures.items.empty()) section.blocks.emplace_back(std::move(figures));
  Table parts = parts_table(rows, say);
  if (!parts.rows.empty()) section.blocks.emplace_back(std::move(parts));
  if (section.blocks.empty()) return std::nullopt;
  return section;
}

Section verification_definitions_section(const std::vector<VerifiedRow>& rows,
                                         const Language& say) {
  return {"definitions", say("verification.definitions"), "", {definitions_table(rows, say)}};
}

}  // namespace

Page verification_page(const DocumentView& document, const Language& say) {
  const std::vector<VerifiedRow> rows = verified_rows(document, say);
  Page page;
  page.title = say("verification.title", document.text("standard"));
  page.subtitle = document.text("name");
  page.stamp = verification_stamp(document, rows, say);
  page.sections.push_back(verification_summary_section(document, rows, say));
  page.sections.push_back(judgement_section(document, rows, say));
  if (auto values = values_section(rows, say)) page.sections.push_back(std::move(*values));
  if (auto artefacts = artefacts_section(document, say)) {
    page.sections.push_back(std::move(*artefacts));
  }
  if (auto budgets = budgets_section(document, rows, say)) {
    page.sections.push_back(std::move(*budgets));
  }
  page.sections.push_back(verification_definitions_section(rows, say));
  return page;
}

}  // namespace armcal
