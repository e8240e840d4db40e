// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/units.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace armcal {
namespace {

TEST(Units, KnownConversions) {
  EXPECT_DOUBLE_EQ(radians_from_degrees(180.0), std::numbers::pi);
  EXPECT_DOUBLE_EQ(degrees_from_radians(std::numbers::pi / 2.0), 90.0);
  EXPECT_DOUBLE_EQ(radians_from_arcseconds(3600.0), std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(millimetres_from_metres(0.439), 439.0);
  EXPECT_DOUBLE_EQ(millimetres_from_inches(0.003), 0.0762);
}

RC_GTEST_PROP(Units, ThereAndBackAgainWithinOneRounding, (double x)) {
  RC_PRE(std::isfinite(x) && std::abs(x) < 1e300);
  const double tolerance = 4e-16 * std::abs(x);
  RC_ASSERT(std::abs(degrees_from_radians(radians_from_degrees(x)) - x) <= tolerance);
  RC_ASSERT(std::abs(arcseconds_from_radians(radians_from_arcseconds(x)) - x) <= 2 * tolerance);
  RC_ASSERT(std::abs(metres_from_millimetres(millimetres_from_metres(x)) - x) <= tolerance);
}

}  // namespace
}  // namespace armcal
