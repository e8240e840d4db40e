// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/median.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(Median, IsTheMiddleOfAnOddNumberOfValues) { EXPECT_EQ(median({9.0, 1.0, 4.0}), 4.0); }

TEST(Median, IsHalfwayBetweenTheMiddleTwoOfAnEvenNumber) {
  EXPECT_EQ(median({9.0, 1.0, 4.0, 2.0}), 3.0);
}

TEST(Median, OfOneValueIsThatValue) { EXPECT_EQ(median({7.0}), 7.0); }

TEST(Median, OfNothingIsAMistakeOfTheCaller) { EXPECT_DEATH((void)median({}), "values.empty"); }

}  // namespace
}  // namespace armcal
