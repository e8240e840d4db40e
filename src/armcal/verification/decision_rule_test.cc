// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/decision_rule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "armcal/core/random.h"

namespace armcal {
namespace {

constexpr double kMpe = 0.030;
constexpr ExpandedUncertainty kU10{0.005, 2.0};  // U = 0.010

Verdict verdict(double error, const DecisionRule& rule, const ExpandedUncertainty& u = kU10) {
  return decide(error, u, ToleranceLimits::about_zero(kMpe), rule);
}

TEST(DecisionRule, Iso14253LeavesTheZonesAboutTheLimitsUndecided) {
  const DecisionRule rule;
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(verdict(sign * 0.019, rule), Verdict::pass);
    EXPECT_EQ(verdict(sign * 0.020, rule), Verdict::pass);  // 0.030 - 0.010 in binary is 0.0199..
    EXPECT_EQ(verdict(sign * 0.0201, rule), Verdict::undecided);
    EXPECT_EQ(verdict(sign * 0.030, rule), Verdict::undecided);
    EXPECT_EQ(verdict(sign * 0.040, rule), Verdict::undecided);
    EXPECT_EQ(verdict(sign * 0.0401, rule), Verdict::fail);
  }
}

TEST(DecisionRule, NothingPassesWhereTheUncertaintyExceedsTheLimit) {
  const ExpandedUncertainty wide{0.020, 2.0};
  EXPECT_EQ(verdict(0.0, {}, wide), Verdict::undecided);
  EXPECT_EQ(verdict(0.069, {}, wide), Verdict::undecided);
  EXPECT_EQ(verdict(0.071, {}, wide), Verdict::fail);
}

TEST(DecisionRule, ConformanceProbabilityIsNarrowerThanU) {
  const DecisionRule rule{.kind = DecisionKind::conformance_probability, .probability = 0.95};
  EXPECT_NEAR(guard_band(rule, kU10), 1.6448536269514722 * 0.005, 1e-15);
  EXPECT_EQ(verdict(0.0217, rule), Verdict::pass);
  EXPECT_EQ(verdict(0.0218, rule), Verdict::undecided);
  EXPECT_EQ(verdict(0.0383, rule), Verdict::fail);
}

TEST(DecisionRule, SimpleAcceptanceAndGuardBandsKnowNoDoubt) {
  const DecisionRule simple{.kind = DecisionKind::simple_acceptance};
  EXPECT_EQ(verdict(0.030, simple), Verdict::pass);
  EXPECT_EQ(verdict(-0.0301, simple), Verdict::fail);
  const DecisionRule guarded{.kind = DecisionKind::guard_band, .guard_factor = 0.5};
  EXPECT_EQ(verdict(0.025, guarded), Verdict::pass);
  EXPECT_EQ(verdict(0.0251, guarded), Verdict::fail);
  const DecisionRule lenient{.kind = DecisionKind::guard_band, .guard_factor = -1.0};
  EXPECT_EQ(verdict(0.040, lenient), Verdict::pass);
}

TEST(DecisionRule, OneLimitIsEnough) {
  const ToleranceLimits form = ToleranceLimits::at_most(kMpe);
  EXPECT_EQ(decide(0.001, kU10, form, {}), Verdict::pass);
  EXPECT_EQ(decide(0.025, kU10, form, {}), Verdict::undecided);
  EXPECT_EQ(decide(0.041, kU10, form, {}), Verdict::fail);
  const ToleranceLimits at_least{.lower = 490.0, .upper = {}};
  EXPECT_EQ(decide(1e9, {8.6, 2.0}, at_least, {}), Verdict::pass);
  EXPECT_EQ(decide(470.0, {8.6, 2.0}, at_least, {}), Verdict::fail);
}

TEST(DecisionRule, WithoutUncertaintyAllRulesAgree) {
  for (const DecisionKind kind : {DecisionKind::iso14253_1, DecisionKind::conformance_probability,
                                  DecisionKind::simple_acceptance, DecisionKind::guard_band}) {
    EXPECT_EQ(verdict(0.0299, {.kind = kind}, {}), Verdict::pass) << to_string(kind);
    EXPECT_EQ(verdict(0.0301, {.kind = kind}, {}), Verdict::fail) << to_string(kind);
  }
}

RC_GTEST_PROP(DecisionRuleAnywhere, MoreErrorNeverHelpsAndMoreDoubtNeverDecides, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
  const DecisionRule rule{
      .kind = *rc::gen::element(DecisionKind::iso14253_1, DecisionKind::conformance_probability)};
  const double u = random.uniform(0.0, 0.03);
  const double error = random.uniform(0.0, 0.1);
  const double more = error + random.uniform(0.0, 0.05);
  RC_ASSERT(verdict(more, rule, {u, 2.0}) >= verdict(error, rule, {u, 2.0}));
  const Verdict doubtful = verdict(error, rule, {u + random.uniform(0.0, 0.03), 2.0});
  RC_ASSERT(doubtful == Verdict::undecided || doubtful == verdict(error, rule, {u, 2.0}));
}

TEST(ConformanceProbability, IsHalfAtALimitAndCountsBothTails) {
  const ToleranceLimits limits = ToleranceLimits::about_zero(1.0);
  EXPECT_NEAR(conformance_probability(1.0, 0.1, limits), 0.5, 1e-15);
  // Within one standard uncertainty either side: 68.27 %.
  EXPECT_NEAR(conformance_probability(0.0, 1.0, limits), std::erf(1.0 / std::sqrt(2.0)), 1e-15);
  EXPECT_EQ(conformance_probability(0.5, 0.0, limits), 1.0);
  EXPECT_EQ(conformance_probability(1.5, 0.0, limits), 0.0);
}

TEST(ConformanceProbability, KeepsItsDigitsFarOutside) {
  // Ten standard uncertainties outside, either side: 7.6e-24, not 0.
  const ToleranceLimits limits = ToleranceLimits::about_zero(1.0);
  const double above = conformance_probability(2.0, 0.1, limits);
  EXPECT_NEAR(above, 7.61985302416053e-24, 1e-35);
  EXPECT_NEAR(conformance_probability(-2.0, 0.1, limits), above, 1e-35);
}

TEST(DecisionRule, RefusesNonsenseInWords) {
  const auto message = [](auto&& action) -> std::string {
    try {
      static_cast<void>(action());
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  EXPECT_EQ(message([] { return decide(0.0, {}, {}, {}); }),
            "limits: neither a lower nor an upper one is given");
  EXPECT_EQ(message([] { return decide(0.0, {}, {.lower = 2.0, .upper = 1.0}, {}); }),
            "limits: lower 2 is above upper 1");
  EXPECT_EQ(message([] {
              return verdict(0.0, {}, {-1.0, 2.0});
            }),
            "standard uncertainty -1: must not be negative");
  EXPECT_EQ(message([] {
              return verdict(0.0, {}, {1.0, 0.0});
            }),
            "coverage factor 0: must be larger than 0");
  EXPECT_EQ(message([] {
              return verdict(0.0,
                             {.kind = DecisionKind::conformance_probability, .probability = 1.0});
            }),
            "probability of conformance 1: must be at least 0.5 and below 1");
  EXPECT_EQ(verdict(NAN, {}), Verdict::not_judged);
}

TEST(Verdict, TheWorstOfSeveralCounts) {
  using enum Verdict;
  EXPECT_EQ(worst(std::array{pass, undecided, not_judged}), undecided);
  EXPECT_EQ(worst(std::array{pass, fail, undecided}), fail);
  EXPECT_EQ(worst(std::array{not_judged, pass}), pass);
  EXPECT_EQ(worst({}), not_judged);
  EXPECT_EQ(to_string(undecided), "undecided");
}

}  // namespace
}  // namespace armcal
