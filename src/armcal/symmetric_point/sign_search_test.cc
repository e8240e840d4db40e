// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/sign_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "armcal/symmetric_point/adjustment.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;

// All signs positive: what a reader of the paper knows.
ArmModel unsigned_nominal() { return testing::romer_arm(80, 25, 750, 530, 175, 0); }

TEST(SignSearch, FindsTheSetThatReproducesThePaperAndItsMirror) {
  const std::vector<std::string> unknown = {"a5", "a7", "direction4", "direction6"};
  const auto combinations = search_signs(unsigned_nominal(), testing::wang2016_readings(), unknown);
  ASSERT_EQ(combinations.size(), 16u);
  ASSERT_EQ(count_equally_good(combinations), 2u);
  // a5 = +, a7 = -, theta4 = +90, theta6 = -90 as in the postures; and everything mirrored.
  EXPECT_THAT(combinations[0].turned, ElementsAre("a7"));
  EXPECT_THAT(combinations[1].turned, ElementsAre("a5", "direction4", "direction6"));
  // The nominal lengths are 2 mm off; every other combination misses by ten times as much.
  EXPECT_GT(combinations[2].misfit, 5.0 * combinations[0].misfit);
}

TEST(SignSearch, OneOfEightWithJoint4Known) {
  const std::vector<std::string> unknown = {"a5", "a7", "direction6"};
  const auto combinations = search_signs(unsigned_nominal(), testing::wang2016_readings(), unknown);
  EXPECT_EQ(combinations.size(), 8u);
  EXPECT_EQ(count_equally_good(combinations), 1u);
}

TEST(SignSearch, WithoutUnknownSignsThereIsOneCombination) {
  const auto combinations = search_signs(unsigned_nominal(), testing::wang2016_readings(), {});
  ASSERT_EQ(combinations.size(), 1u);
  EXPECT_TRUE(combinations[0].turned.empty());
}

TEST(SignSearch, RefusesWhatItDoesNotKnow) {
  const std::vector<std::string> unknown = {"direction7"};
  EXPECT_THROW(
      static_cast<void>(search_signs(unsigned_nominal(), testing::wang2016_readings(), unknown)),
      std::invalid_argument);
  const std::vector<std::string> many(13, "a5");
  EXPECT_THROW(
      static_cast<void>(search_signs(unsigned_nominal(), testing::wang2016_readings(), many)),
      std::invalid_argument);
}

}  // namespace
}  // namespace armcal
