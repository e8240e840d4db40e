// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "armcal/testing/reference_data.h"
#include "armcal/verification/decision_risk.h"
#include "armcal/verification/decision_rule.h"

// Published decisions and those generated from the rules, one record each.
namespace armcal {
namespace {

using Record = nlohmann::json;

double number(const Record& record, const char* key) {
  const Record& value = record.at(key);
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

ToleranceLimits limits_of(const Record& record) {
  ToleranceLimits limits;
  for (const char* key : {"limit_lower", "LSL"}) {
    if (record.contains(key)) limits.lower = number(record, key);
  }
  for (const char* key : {"limit_upper", "USL"}) {
    if (record.contains(key)) limits.upper = number(record, key);
  }
  return limits;
}

const char* word_for(Verdict verdict) {
  if (verdict == Verdict::pass) return "conform";
  return verdict == Verdict::fail ? "nonconform" : "undecided";
}

void expect_decision(const Record& record) {
  const double u = number(record, "u");
  const double y = number(record, "y");
  const ToleranceLimits limits = limits_of(record);
  const DecisionRule rule{.kind = DecisionKind::conformance_probability, .probability = 0.95};
  EXPECT_STREQ(word_for(decide(y, {u, 2.0}, limits, rule)),
               record.at("decision").get<std::string>().c_str())
      << record.at("id");
  if (!record.contains("conformance_probability")) return;
  // 9.95 and 10.05 are rounded to binary: 1e-15 of 10, over u = 0.01, times the density's slope.
  const double exact = number(record, "conformance_probability");
  EXPECT_NEAR(conformance_probability(y, u, limits), exact, 1e-12 * (1.0 + exact))
      << record.at("id");
}

void expect_conformance(const Record& record) {
  const double p =
      conformance_probability(number(record, "y"), number(record, "u"), limits_of(record));
  EXPECT_NEAR(p, number(record, "exact"), 1e-12) << record.at("id");
  EXPECT_NEAR(p, number(record, "published_conformance_probability"), 0.005) << record.at("id");
}

void expect_action_limit(const Record& record) {
  const double limit = action_limit(number(record, "limit_upper"), number(record, "relative_u"),
                                    number(record, "probability"));
  EXPECT_NEAR(limit, number(record, "exact_limit"), 1e-9);  // its digits
  EXPECT_EQ(std::round(limit), number(record, "published_action_limit"));
}

void expect_guard_factor(const Record& record) {
  const DecisionRule rule{.kind = DecisionKind::conformance_probability,
                          .probability = number(record, "conformance_probability")};
  const double factor = guard_band(rule, {1.0, 2.0});
  const double exact = number(record, "exact_factor");
  EXPECT_NEAR(factor, exact, 1e-10 * exact) << record.at("id");
  // Two digits are published, rounded up in part: 1.645 is printed 1.65.
  EXPECT_NEAR(factor, number(record, "published_factor"), 0.0055) << record.at("id");
}

void expect_rp19(const Record& record) {
  const auto limits = ToleranceLimits::about_zero(1.0);
  const auto& shares = record.at("in_tolerance_probability");
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double share = shares[i].get<double>();
    // Standard deviation of the process whose share within -1 .. 1 is as stated.
    const DecisionRule upper{.kind = DecisionKind::conformance_probability,
                             .probability = 0.5 * (1.0 + share)};
    const double sigma = 1.0 / guard_band(upper, {1.0, 2.0});
    const DecisionRisk risk = decision_risk({0.0, sigma, sigma / 4.0}, limits, limits);
    const double tolerance = record.at("tolerance").get<double>();
    EXPECT_NEAR(100.0 * risk.false_acceptance, record.at("PFA_percent")[i].get<double>(),
                tolerance);
    EXPECT_NEAR(100.0 * risk.false_among_accepted(),
                record.at("conditional_PFA_percent")[i].get<double>(), tolerance);
  }
}

void expect_deaver(const Record& record) {
  const double limit = number(record, "SL_sigma");
  const auto limits = ToleranceLimits::about_zero(limit);
  // The ratio of Deaver's example is that of the process's standard deviation to the measurement's.
  const DecisionRisk risk = decision_risk({0.0, 1.0, 1.0 / number(record, "TUR")}, limits, limits);
  EXPECT_NEAR(risk.false_acceptance, number(record, "PFA"), number(record, "tolerance"));
  EXPECT_NEAR(risk.false_rejection, number(record, "PFR"), number(record, "tolerance"));
}

TEST(DecisionRecords, EveryOneIsReproduced) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  std::ifstream file(testing::reference_data() / "oracles/statistics/decisions.json");
  int count = 0;
  for (const Record& record : Record::parse(file)) {
    ++count;
    const auto id = record.at("id").get<std::string>();
    if (record.contains("decision")) {
      expect_decision(record);
    } else if (record.contains("published_conformance_probability")) {
      expect_conformance(record);
    } else if (record.contains("published_action_limit")) {
      expect_action_limit(record);
    } else if (record.contains("exact_factor")) {
      expect_guard_factor(record);
    } else if (id == "NCSLI_RP19_PFA") {
      expect_rp19(record);
    } else if (id == "Deaver_PFA") {
      expect_deaver(record);
    } else {
      ADD_FAILURE() << "no test for " << id;
    }
  }
  EXPECT_EQ(count, 28);
}

TEST(DecisionRisk, AccountsForEverything) {
  // Conforming = accepted and conforming + falsely rejected; a wide guard band trades one for the
  // other.
  const auto tolerance = ToleranceLimits::about_zero(2.0);
  const DecisionRisk plain = decision_risk({0.3, 1.0, 0.2}, tolerance, tolerance);
  const double conforming = conformance_probability(0.3, 1.0, tolerance);
  EXPECT_NEAR(plain.accepted - plain.false_acceptance + plain.false_rejection, conforming, 1e-12);
  EXPECT_NEAR(plain.accepted, conformance_probability(0.3, std::hypot(1.0, 0.2), tolerance), 1e-12);
  const DecisionRisk guarded =
      decision_risk({0.3, 1.0, 0.2}, tolerance, ToleranceLimits::about_zero(1.7));
  EXPECT_LT(guarded.false_acceptance, plain.false_acceptance);
  EXPECT_GT(guarded.false_rejection, plain.false_rejection);
}

TEST(DecisionRisk, FollowsAnInstrumentThatIsFarBetterThanTheProcess) {
  // For a vanishing uncertainty u both errors are g0(T) u / sqrt(2 pi) at each limit.
  const auto limits = ToleranceLimits::at_most(1.0);
  const double u = 1e-5;
  const DecisionRisk risk = decision_risk({0.0, 1.0, u}, limits, limits);
  const double expected = std::exp(-0.5) / (2.0 * M_PI) * u;
  EXPECT_NEAR(risk.false_acceptance, expected, 1e-4 * expected);
  EXPECT_NEAR(risk.false_rejection, expected, 1e-4 * expected);
}

}  // namespace
}  // namespace armcal
