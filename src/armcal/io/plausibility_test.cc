// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/plausibility.h"

#include <gtest/gtest.h>

#include <limits>

namespace armcal {
namespace {

bool suspicious(std::vector<double> degrees) { return look_like_radians(degrees); }

TEST(Plausibility, KnowsRadiansByTheirQuarterTurns) {
  EXPECT_TRUE(suspicious({1.5708, 0, -1.5708}));
  EXPECT_TRUE(suspicious({0, 3.14, 0.1}));
  EXPECT_TRUE(suspicious({1.57}));
  EXPECT_FALSE(suspicious({90, 0, 1.5708}));  // one twist may be what it is
  EXPECT_FALSE(suspicious({0, 0.02, -0.1}));  // small errors of a nearly straight arm
  EXPECT_FALSE(suspicious({1.0, 2.0}));
  EXPECT_FALSE(suspicious({}));
}

TEST(Plausibility, NoArmIsAKilometreLong) {
  Diagnostics diagnostics;
  EXPECT_EQ(checked_length(-1e6, "b_mm", {}, diagnostics), -1e6);
  EXPECT_FALSE(diagnostics.has_errors());
  for (const double length : {1.1e6, -1e300, std::numeric_limits<double>::infinity()}) {
    static_cast<void>(checked_length(length, "b_mm", {"a.toml", 3, 1}, diagnostics));
  }
  EXPECT_EQ(diagnostics.error_count(), 3u);
  EXPECT_EQ(to_string(diagnostics.entries()[0]).substr(0, 41),
            "a.toml:3:1: error: b_mm is 1100000 mm: lo");
}

}  // namespace
}  // namespace armcal
