// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/judgement.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace armcal {
namespace {

using Mpe = MaximumPermissibleError;
constexpr ExpandedUncertainty kSmallU{0.001, 2.0};

TestResult result_with(double value_mm, bool is_signed = true) {
  TestResult result;
  result.name = "a test";
  result.value_mm = value_mm;
  result.is_signed = is_signed;
  return result;
}

// Errors of 30 um at 2 m and 25 um at 100 mm.
TestResult two_lengths() {
  TestResult result = result_with(0.030);
  result.parts = {{.name = "long", .value_mm = 0.030, .length_mm = 2000.0},
                  {.name = "short", .value_mm = -0.025, .length_mm = 100.0}};
  return result;
}

TEST(Judgement, HoldsTheValueAgainstItsLimit) {
  const Judged judged = judge(result_with(-0.010), Mpe::constant(0.030), kSmallU, {});
  EXPECT_EQ(judged.verdict, Verdict::pass);
  EXPECT_EQ(judged.value_mm, -0.010);
  EXPECT_EQ(judged.mpe_mm, 0.030);
  EXPECT_EQ(judged.U_mm, 0.002);
  EXPECT_NEAR(judged.share_of_mpe.value(), 1.0 / 3.0, 1e-15);
  EXPECT_GT(judged.conformance_probability.value(), 0.999);
  EXPECT_FALSE(judged.deciding_part.has_value());
  EXPECT_EQ(judge(result_with(-0.033), Mpe::constant(0.030), kSmallU, {}).verdict, Verdict::fail);
}

TEST(Judgement, WhatCannotBeNegativeHasOneLimit) {
  // With a limit on either side the probability would count a form error below -MPE.
  const ExpandedUncertainty wide{0.030, 2.0};
  const Judged form = judge(result_with(0.0, false), Mpe::constant(0.030), wide, {});
  const Judged size = judge(result_with(0.0, true), Mpe::constant(0.030), wide, {});
  EXPECT_NEAR(form.conformance_probability.value(), 0.8413447460685429, 1e-12);
  EXPECT_NEAR(size.conformance_probability.value(), 0.6826894921370859, 1e-12);
}

TEST(Judgement, EveryLengthHasItsOwnLimit) {
  // 20 um + L/50: 60 um at 2 m, 22 um at 100 mm. The smaller error is the one that fails.
  const Judged judged = judge(two_lengths(), Mpe::linear(0.020, 50.0), kSmallU, {});
  EXPECT_EQ(judged.verdict, Verdict::fail);
  EXPECT_EQ(judged.deciding_part, 1u);
  EXPECT_EQ(judged.value_mm, -0.025);
  EXPECT_NEAR(judged.mpe_mm.value(), 0.022, 1e-15);
  EXPECT_EQ(judged.result.value_mm, 0.030);
  // With one limit for all it is the larger.
  EXPECT_EQ(judge(two_lengths(), Mpe::constant(0.040), kSmallU, {}).deciding_part, 0u);
}

TEST(Judgement, EveryLengthMayHaveItsOwnUncertainty) {
  const std::vector<ExpandedUncertainty> each = {{0.020, 2.0}, {0.001, 2.0}};
  const Judged judged = judge(two_lengths(), Mpe::constant(0.040), each, {});
  EXPECT_EQ(judged.verdict, Verdict::undecided);  // 30 + 40 um reach across 40 um
  EXPECT_EQ(judged.deciding_part, 0u);
  EXPECT_EQ(judged.U_mm, 0.040);
}

TEST(Judgement, WithoutLimitOrValueThereIsNone) {
  const Judged unlimited = judge(result_with(0.010), {}, kSmallU, {});
  EXPECT_EQ(unlimited.verdict, Verdict::not_judged);
  EXPECT_EQ(unlimited.value_mm, 0.010);
  EXPECT_EQ(unlimited.U_mm, 0.002);
  TestResult nothing;
  EXPECT_EQ(judge(nothing, Mpe::constant(0.030), kSmallU, {}).verdict, Verdict::not_judged);
}

TEST(Judgement, RefusesWhatDoesNotFitTogether) {
  const std::array<ExpandedUncertainty, 2> two = {kSmallU, kSmallU};
  EXPECT_THROW(static_cast<void>(judge(result_with(0.0), Mpe::constant(0.03), two, {})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(judge(result_with(0.0), Mpe::linear(0.03, 50.0), kSmallU, {})),
               std::invalid_argument);
}

}  // namespace
}  // namespace armcal
