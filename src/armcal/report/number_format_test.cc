// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/number_format.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(NumberFormat, NeverShowsMinusZero) {
  EXPECT_EQ(fixed(-0.0001, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(12.3456, 2), "12.35");
}

TEST(NumberFormat, RoundsToTwoDigitsOfTheUncertainty) {
  EXPECT_EQ(with_uncertainty(78.31204, 0.002121), "78.3120 +- 0.0021");
  EXPECT_EQ(with_uncertainty(747.4882, 0.00995), "747.488 +- 0.010");
  EXPECT_EQ(with_uncertainty(12.0, 3.2), "12.0 +- 3.2");
  EXPECT_EQ(with_uncertainty(1234.0, 560.0), "1230 +- 560");
  EXPECT_EQ(with_uncertainty(-23456.0, 996.0), "-23500 +- 1000");
  EXPECT_EQ(with_uncertainty(12.0, 560.0), "10 +- 560");
  EXPECT_EQ(fixed(-4.0, -1), "0");
}

TEST(NumberFormat, SurvivesUncertaintiesThatAreNone) {
  EXPECT_EQ(with_uncertainty(1.0, 0.0), "1.0000 +- 0.0000");
}

}  // namespace
}  // namespace armcal
