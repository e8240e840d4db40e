// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/chain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

TEST(Chain, TakesOneParameterFromEachReading) {
  const Chain chain = solve_chain(testing::nominal_romer(), testing::wang2016_readings());
  ASSERT_TRUE(chain.complete);
  ASSERT_EQ(chain.steps.size(), 5u);  // R solves nothing
  EXPECT_EQ(chain.steps[0].parameter, "b7");
  EXPECT_NEAR(chain.steps[0].value, 176.484, 1e-9);
  EXPECT_EQ(chain.steps[4].parameter, "b3");
  EXPECT_NEAR(chain.steps[4].value, 747.4885, 1e-9);
}

TEST(Chain, PropagatesTheUncertaintyOfAllEarlierReadings) {
  const Chain chain = solve_chain(testing::nominal_romer(), testing::wang2016_readings());
  const double u = 0.003;
  EXPECT_NEAR(chain.steps[0].u, u / 2, 1e-9);                   // b7 = l1/2
  EXPECT_NEAR(chain.steps[2].u, u / 2 * std::sqrt(2.0), 1e-9);  // a5 = l3/2 + l2/2
  EXPECT_NEAR(chain.steps[4].u, u / 2 * std::sqrt(4.0), 1e-9);  // b3 = l5/2 + l1/2 - l3/2 - l2/2
}

TEST(Chain, TheNominalSignChoosesBetweenMirrorSolutions) {
  ArmModel mirrored = testing::nominal_romer();
  mirrored.links[3].a_mm = -80.0;
  mirrored.tip.a_mm = 25.0;
  mirrored.joints[3].direction = -1;  // theta4 = -90 and theta6 = +90 in the postures
  mirrored.joints[5].direction = -1;
  const Chain chain = solve_chain(mirrored, testing::wang2016_readings());
  ASSERT_TRUE(chain.complete) << chain.problem;
  EXPECT_NEAR(chain.arm.links[3].a_mm, -78.312, 1e-9);
  EXPECT_NEAR(chain.arm.tip.a_mm, 25.962, 1e-9);
  EXPECT_NEAR(chain.arm.links[1].b_mm, 747.4885, 1e-9);
}

TEST(Chain, BreaksOffWhereAReadingDoesNotDependOnItsParameter) {
  auto readings = testing::wang2016_readings();
  readings[0].solves = "b3";  // joint 5 turns: the link before it moves nothing
  const Chain chain = solve_chain(testing::nominal_romer(), readings);
  EXPECT_FALSE(chain.complete);
  EXPECT_EQ(chain.problem, "l_PP1 cannot be solved for b3");
}

TEST(Chain, BreaksOffWhereNoValueFits) {
  auto readings = testing::wang2016_readings();
  readings[1].value = 352.968 * 3;  // a tip that long would contradict nothing, but
  readings[1].solves = "b7";        // with theta6 = 0 the tip arm b7 is not seen at all
  EXPECT_FALSE(solve_chain(testing::nominal_romer(), readings).complete);
}

// Two readings of one radius were solved for both sides of the tip and crashed what came after.
TEST(Chain, IsBrokenWhereTheReadingsDoNotTellTheirParametersApart) {
  auto first = testing::circle_radius("r1", 6, testing::degrees({0, 0, 0, 0, 0, 0}), 178.383);
  auto second = first;
  second.name = "r2";
  first.solves = "b7";
  second.solves = "a7";
  const Chain chain =
      solve_chain(testing::nominal_romer(), std::vector<SymmetricReading>{first, second});
  EXPECT_FALSE(chain.complete);
  EXPECT_TRUE(chain.steps.empty());
  EXPECT_EQ(chain.problem, "r1, r2 cannot tell a7 from the rest: a7 moves every reading like b7");
}

}  // namespace
}  // namespace armcal
