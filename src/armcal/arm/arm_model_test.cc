// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/arm_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/random_arms.h"

namespace armcal {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ArmModel, SoundArmsHaveNoProblems) {
  RandomStream random(1);
  for (int n = kMinJoints; n <= kMaxJoints; ++n) {
    EXPECT_THAT(problems_of(testing::random_arm(n, random)), IsEmpty()) << n;
  }
}

TEST(ArmModel, TellsEveryProblemAtOnce) {
  RandomStream random(2);
  ArmModel arm = testing::random_arm(6, random);
  arm.joints[2].direction = 0;
  arm.joints[3].min_rad = 2.0;
  arm.joints[3].max_rad = 1.0;
  arm.links[4].b_mm = std::numeric_limits<double>::quiet_NaN();
  arm.links.emplace_back();
  const auto problems = problems_of(arm);
  EXPECT_EQ(problems.size(), 4u);
  EXPECT_THAT(problems, Contains("joint 3: direction 0 is neither 1 nor -1"));
  EXPECT_THAT(problems, Contains(HasSubstr("joint 4: lower limit")));
  EXPECT_THAT(problems, Contains("link into joint 6: a number is not finite"));
  EXPECT_THAT(problems, Contains(HasSubstr("6 links for 6 joints")));
}

TEST(ArmModel, RefusesTooFewAndTooManyJoints) {
  EXPECT_THAT(problems_of(ArmModel{}), Contains("0 joints: an arm here has 2 to 10"));
  RandomStream random(3);
  EXPECT_THAT(problems_of(testing::random_arm(11, random)),
              Contains("11 joints: an arm here has 2 to 10"));
}

TEST(ArmModel, ReachIsTheLengthOfTheStretchedChain) {
  ArmModel arm;
  arm.joints.resize(2);
  arm.links = {{3.0, 4.0, 0.0, 1.0, 0.0}};
  arm.tip = {.d_mm = 2.0};
  EXPECT_DOUBLE_EQ(reach_mm(arm), 7.0);
}

}  // namespace
}  // namespace armcal
