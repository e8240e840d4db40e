// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "armcal/report/number_format.h"
#include "armcal/report/symmetric_point_amounts.h"
#include "armcal/report/symmetric_point_report.h"

namespace armcal {
namespace {

std::string contradicted_claims_finding(const SymmetricPointAnalysis& analysis,
                                        const std::string& reading_name) {
  std::vector<std::string> claims;
  double reconciling = 0.0;
  for (const ClaimCheck& claim : analysis.claims) {
    if (claim.contradicted_by != reading_name) continue;
    claims.push_back(fmt::format("{} = {}", claim.name, amount(claim.claimed, claim.is_angle, 3)));
    reconciling = *claim.reconciled_by;
  }
  for (const SymmetricReading& reading : analysis.readings) {
    if (reading.name != reading_name) continue;
    return fmt::format("{} = {} contradicts {}; {} agrees with {}.", reading.name,
                       amount(reading.value, reading.is_angle(), 3), joined_names(claims),
                       amount(reconciling, reading.is_angle(), 3),
                       claims.size() == 1   ? "it"
                       : claims.size() == 2 ? "both"
                                            : "all of them");
  }
  return {};
}

void add_claim_findings(const SymmetricPointAnalysis& analysis, std::vector<std::string>& found) {
  std::set<std::string> told;
  for (const ClaimCheck& claim : analysis.claims) {
    if (claim.agrees) continue;
    if (claim.contradicted_by) {
      if (told.insert(*claim.contradicted_by).second) {
        found.push_back(contradicted_claims_finding(analysis, *claim.contradicted_by));
      }
      continue;
    }
    std::string sentence = fmt::format(
        "{} = {} contradicts the readings, which give {}; no single reading reconciles it.",
        claim.name, amount(claim.claimed, claim.is_angle, 3),
        amount(claim.value, claim.is_angle, 3));
    if (!claim.equals.empty()) {
      sentence += fmt::format(" It is the same length as {}.", joined_names(claim.equals));
    }
    found.push_back(sentence);
  }
}

void add_check_findings(const SymmetricPointAnalysis& analysis, std::vector<std::string>& found) {
  std::set<std::string> told;
  std::vector<std::string> unchecked;
  for (const AdjustedReading& reading : analysis.adjustment.readings) {
    if (!reading.normalised) unchecked.push_back(reading.name);
    if (!reading.flagged || told.contains(reading.name)) continue;
    std::vector<std::string> group = {reading.name};
    group.insert(group.end(), reading.inseparable_from.begin(), reading.inseparable_from.end());
    told.insert(group.begin(), group.end());
    std::vector<std::string> errors;
    for (const AdjustedReading& one : analysis.adjustment.readings) {
      if (std::find(group.begin(), group.end(), one.name) == group.end()) continue;
      errors.push_back(fmt::format("{} by {} {}", one.name,
                                   amount(*one.estimated_error, one.is_angle, 3),
                                   unit_of_amount(one.is_angle)));
    }
    if (group.size() == 1) {
      found.push_back(
          fmt::format("{} does not agree with the other readings: it seems to be off by {} {} "
                      "(normalised residual {}, "
                      "limit {}).",
                      reading.name, amount(*reading.estimated_error, reading.is_angle, 3),
                      unit_of_amount(reading.is_angle), fixed(*reading.normalised, 1),
                      fixed(analysis.adjustment.critical_value, 2)));
    } else {
      found.push_back(fmt::format(
          "The one check that {} give each other fails (normalised residual {}, limit {}): one of "
          "them is "
          "wrong, and these readings cannot tell which. To be right again they would change {}.",
          joined_names(group), fixed(std::abs(*reading.normalised), 1),
          fixed(analysis.adjustment.critical_value, 2), joined_names(errors)));
    }
  }
  if (!unchecked.empty()) {
    std::vector<std::string> solved;
    for (const SymmetricReading& reading : analysis.readings) {
      const bool is_unchecked =
          std::find(unchecked.begin(), unchecked.end(), reading.name) != unchecked.end();
      if (is_unchecked && !reading.solves.empty()) solved.push_back(reading.solves);
    }
    found.push_back(
        fmt::format("{} {} checked by nothing: an error of theirs goes whole into the result{}.",
                    joined_names(unchecked), unchecked.size() == 1 ? "is" : "are",
                    solved.empty() ? "" : " (" + joined_names(solved) + ")"));
  }
}

void add_sign_findings(const SymmetricPointAnalysis& analysis, std::vector<std::string>& found) {
  if (analysis.signs.size() < 2) return;
  const std::size_t equally_good = count_equally_good(analysis.signs);
  std::string sentence = fmt::format("Of {} combinations of signs ", analysis.signs.size());
  const auto turned = [](const SignCombination& combination) {
    return combination.turned.empty() ? std::string("all as in the arm file")
                                      : "turned: " + joined_names(combination.turned);
  };
  sentence +=
      equally_good == 1
          ? fmt::format("one fits best ({})", turned(analysis.signs[0]))
          : fmt::format("{} fit equally well, being mirror images of each other (", equally_good);
  if (equally_good > 1) {
    for (std::size_t i = 0; i < equally_good; ++i) {
      sentence += (i == 0 ? "" : "; ") + turned(analysis.signs[i]);
    }
    sentence += ")";
  }
  if (equally_good < analysis.signs.size() && analysis.signs[0].misfit > 0.0) {
    sentence +=
        fmt::format("; the next misses by {} times as much",
                    fixed(analysis.signs[equally_good].misfit / analysis.signs[0].misfit, 0));
  }
  found.push_back(sentence + ".");
}

// One sentence each, or one for all where everything was asked for and most of it must be held.
void add_held_findings(const std::vector<HeldParameter>& held, std::vector<std::string>& found) {
  constexpr std::size_t kToldOneByOne = 6;
  if (held.size() <= kToldOneByOne) {
    for (const HeldParameter& one : held) {
      found.push_back(fmt::format("{}: {} held.", one.reason, one.name));
    }
    return;
  }
  std::vector<std::string> names;
  for (const HeldParameter& one : held) names.push_back(one.name);
  found.push_back(
      fmt::format("{} parameters are held at their nominal values, since these readings do not "
                  "determine them as well (--json says why for each): {}.",
                  names.size(), joined_names(names)));
}

}  // namespace

std::vector<std::string> findings(const SymmetricPointAnalysis& analysis) {
  std::vector<std::string> found;
  if (analysis.compared) {
    double worst = 0.0;
    std::string at;
    for (std::size_t i = 0; i < analysis.readings.size(); ++i) {
      const SymmetricReading& reading = analysis.readings[i];
      const double miss =
          std::abs(analysis.predicted_by_compared(static_cast<Eigen::Index>(i)) - reading.value);
      if (!reading.is_angle() && miss > worst) {
        worst = miss;
        at = reading.name;
      }
    }
    found.push_back(fmt::format("The arm \"{}\" misses the readings by up to {} mm ({}).",
                                analysis.compared->name, fixed(worst, 3), at));
  }
  add_sign_findings(analysis, found);
  if (analysis.chain && !analysis.chain->complete) {
    found.push_back(fmt::format("The chain of equations breaks off: {}.", analysis.chain->problem));
  }
  if (!analysis.adjustment.ok()) return found;
  add_claim_findings(analysis, found);
  add_check_findings(analysis, found);
  add_held_findings(analysis.adjustment.undetermined, found);
  return found;
}

}  // namespace armcal
