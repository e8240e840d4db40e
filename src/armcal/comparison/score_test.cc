// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/score.h"

#include <gtest/gtest.h>

#include "armcal/arm/parameter_table.h"
#include "armcal/comparison/scenario.h"

namespace armcal {
namespace {

Bench bench() { return bench_of(*scenario_named("romer"), 3); }

FoundArm truth_of(const Bench& bench) { return {.arm = bench.arm.truth()}; }

TEST(Judge, FindsNoFaultInTheTrueArm) {
  const Bench b = bench();
  const Score score = Judge(b.arm, b.u_reference_mm, b.seed, 60).score(truth_of(b));
  // A metre, rounded a few hundred times.
  EXPECT_LT(score.point_max_mm, 1e-10);
  EXPECT_LT(score.length_rms_mm, 1e-10);
  EXPECT_NEAR(score.noise_ratio, 1.0, 1e-9);
  EXPECT_EQ(score.intervals, 0);  // it states no uncertainty
}

TEST(Judge, DoesNotMindWhereTheBaseStands) {
  const Bench b = bench();
  FoundArm moved = truth_of(b);
  moved.arm.base_from_first_joint = {rotation_from_vector({0.3, -1.0, 0.2}), {100.0, 5.0, -30.0}};
  moved.arm.joints.front().zero_rad += 0.7;
  const Score score = Judge(b.arm, b.u_reference_mm, b.seed, 60).score(moved);
  EXPECT_LT(score.point_max_mm, 1e-9);
  EXPECT_LT(score.length_rms_mm, 1e-9);
}

TEST(Judge, SeesAWrongScaleInLengthsAndPoints) {
  const Bench b = bench();
  FoundArm longer = truth_of(b);
  constexpr double kTooLong = 1e-3;
  const ParameterTable table(longer.arm);
  Eigen::VectorXd values = table.nominal();
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].unit == ParameterUnit::mm) values(i) *= 1.0 + kTooLong;
  }
  longer.arm = with_parameter_values(longer.arm, values);
  const Judge judge(b.arm, b.u_reference_mm, b.seed, 200);
  const Score score = judge.score(longer);
  // Tips are about a metre apart, so their distances are about a millimetre too long.
  EXPECT_NEAR(score.length_rms_mm, 1.1, 0.4);
  EXPECT_GT(score.point_rms_mm, 0.3);
  EXPECT_GT(score.noise_ratio, 10.0);
}

TEST(Judge, CountsIntervalsThatHoldTheTruth) {
  const Bench b = bench();
  const ParameterTable table(b.arm.truth());
  FoundArm found = truth_of(b);
  found.free = {*table.find("b3"), *table.find("b5"), *table.find("alpha4")};
  found.u = Eigen::Vector3d(0.01, 0.01, 1e-5);
  Eigen::VectorXd values = table.nominal();
  values(found.free[0]) += 0.019;   // within 1.96 u
  values(found.free[1]) -= 0.020;   // outside
  values(found.free[2]) += 1.9e-5;  // within
  found.arm = with_parameter_values(found.arm, values);
  const Score score = Judge(b.arm, b.u_reference_mm, b.seed, 100).score(found);
  EXPECT_EQ(score.intervals, 3);
  EXPECT_EQ(score.inside, 2);
}

// Held at another value than the true one, d4 makes another b3 the true one: they move the tip
// together where the axes between them are at right angles.
TEST(Judge, TakesTheTruthInTheConventionOfTheMethod) {
  const Bench b = bench();
  const ArmModel& truth = b.arm.truth();
  const ParameterTable table(truth);
  FoundArm found = truth_of(b);
  for (const char* name : {"b3", "a4", "zero3", "zero4", "alpha3", "b2", "a3", "a5", "b5", "b4"})
    found.free.push_back(*table.find(name));
  found.u = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(found.free.size()), 1e-5);
  Eigen::VectorXd values = table.nominal();
  values(*table.find("d4")) += 2.0;
  values(*table.find("b3")) -= 2.0;  // nearly the same arm; "true" b3 is near this value now
  found.arm = with_parameter_values(truth, values);
  found.u(0) = 0.05;
  const Judge judge(b.arm, b.u_reference_mm, b.seed, 100);
  EXPECT_GE(judge.score(found).inside, 1);
}

TEST(Judge, AsksTheSameQuestionsForTheSameSeed) {
  const Bench b = bench();
  const FoundArm found{.arm = b.arm.nominal()};
  const Score one = Judge(b.arm, b.u_reference_mm, 7, 50).score(found);
  const Score same = Judge(b.arm, b.u_reference_mm, 7, 50).score(found);
  const Score other = Judge(b.arm, b.u_reference_mm, 8, 50).score(found);
  EXPECT_EQ(one.point_rms_mm, same.point_rms_mm);
  EXPECT_EQ(one.noise_ratio, same.noise_ratio);
  EXPECT_NE(one.point_rms_mm, other.point_rms_mm);
}

}  // namespace
}  // namespace armcal
