// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/stated_limit.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

constexpr double kRounding = 1e-15;  // of one division

TEST(StatedLimit, IsConstant) {
  const auto limit = limit_of_formula("30");
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->a_mm, 0.030, kRounding);
  EXPECT_FALSE(limit->k);
  EXPECT_FALSE(limit->b_mm);
}

TEST(StatedLimit, GrowsWithLength) {
  const auto limit = limit_of_formula(" 20+ L / 50 ");
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->a_mm, 0.020, kRounding);
  EXPECT_EQ(limit->k, 50.0);
}

TEST(StatedLimit, IsTheSmallerOfTwo) {
  const auto limit = limit_of_formula("min(20 + L/50, 80)");
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->a_mm, 0.020, kRounding);
  EXPECT_EQ(limit->k, 50.0);
  ASSERT_TRUE(limit->b_mm);
  EXPECT_NEAR(*limit->b_mm, 0.080, kRounding);
}

TEST(StatedLimit, TakesNothingElse) {
  for (const char* text :
       {"", "L/50", "20 + L", "20 + L/0", "20 + L/-50", "-20", "0", "20 + 4L/1000", "min(20)",
        "min(20, 80)", "min(20 + L/50, 20)", "min(20 + L/50, )", "min(20 + L/50, 80, 90)", "20 um",
        "20 + L/50, 80", "min(min(20, 30), 40)", "nan", "1e999", "20 + L/50 + L/70"}) {
    EXPECT_FALSE(limit_of_formula(text)) << text;
  }
}

}  // namespace
}  // namespace armcal
