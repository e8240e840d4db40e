// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/symmetric_point_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "armcal/report/number_format.h"
#include "armcal/report/pages/symmetric_point_values.h"
#include "armcal/report/pages/verdict_words.h"

namespace armcal {
namespace {

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
                                  : say("symmetric.signs_turned", listed(turned, say)));
  }
  std::string sentence = say(good == 1 ? "symmetric.signs_one" : "symmetric.signs_several",
                             signs.size(), good, listed(best, say, "symmetric.signs_separator"));
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
    const auto mended = symmetric_amount(claim, "reconciled_by");
    if (culprit && mended) {
      found.push_back(say("symmetric.claim_against_reading", claim.text("name"), claimed, *culprit,
                          fixed(*mended, 3)));
    } else {
      found.push_back(say("symmetric.claim_against_all", claim.text("name"), claimed,
                          fixed(claim.number("value"), 3)));
    }
    std::vector<std::string> equals;
    for (const std::string& same : claim.texts("equals")) equals.push_back(said_length(same, say));
    if (!equals.empty()) found.back() += say("symmetric.claim_equals", listed(equals, say));
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
                            amount_text(symmetric_amount(reading, "estimated_error"), 3),
                            reading.text("unit")));
    }
    const DocumentView& first = group.front();
    const std::string normalised = fixed(std::abs(first.number("normalised")), 1);
    if (group.size() > 1) {
      found.push_back(say("symmetric.group_fails", listed(names, say), normalised, limit,
                          listed(changes, say)));
    } else {
      found.push_back(say("symmetric.reading_fails", names.front(),
                          amount_text(symmetric_amount(first, "estimated_error"), 3),
                          first.text("unit"), normalised, limit));
    }
  }
}

}  // namespace

std::vector<std::vector<DocumentView>> failing_groups(const DocumentView& document) {
  const std::vector<DocumentView> readings = document.list("readings");
  std::set<std::string> told;
  std::vector<std::vector<DocumentView>> groups;
  for (const DocumentView& reading : readings) {
    if (!is_flagged_reading(reading) || told.contains(reading.text("name"))) continue;
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

std::vector<std::string> symmetric_findings(const DocumentView& document, const Language& say) {
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
    if (reading.has("redundancy") && !is_checked_reading(reading)) {
      unchecked.push_back(reading.text("name"));
    }
  }
  if (!unchecked.empty()) found.push_back(say("symmetric.unchecked", listed(unchecked, say)));
  std::vector<std::string> held;
  for (const DocumentView& each : document.list("undetermined")) held.push_back(each.text("name"));
  if (!held.empty()) found.push_back(say("symmetric.undetermined", listed(held, say)));
  return found;
}

}  // namespace armcal
