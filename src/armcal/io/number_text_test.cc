// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/number_text.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "armcal/core/units.h"

namespace armcal {
namespace {

TEST(ParseNumber, TakesWhatInstrumentsWrite) {
  EXPECT_EQ(parse_number("12.5"), 12.5);
  EXPECT_EQ(parse_number("+12.5"), 12.5);
  EXPECT_EQ(parse_number("-1.5E-3"), -1.5e-3);
  EXPECT_EQ(parse_number("\xE2\x88\x92"
                         "3.25"),
            -3.25);
  EXPECT_EQ(parse_number("12,5", true), 12.5);
  EXPECT_EQ(parse_number("7", true), 7.0);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
}

TEST(ParseNumber, RefusesWhatOnlyStartsLikeOne) {
  for (const char* text :
       {"", " ", "12.3.4", "1,234.5", "12mm", "nan", "inf", "1e999", "--1", "+-1", "0x10"}) {
    EXPECT_FALSE(parse_number(text).has_value()) << text;
  }
  EXPECT_FALSE(parse_number("1.234,5", true).has_value());
  EXPECT_FALSE(parse_number("1,2,3", true).has_value());
  EXPECT_FALSE(parse_number(std::string(100, '1'), true).has_value());
}

TEST(SpellsMissing, KnowsTheWordsForNothing) {
  for (const char* text : {"NaN", "-nan", "N/A", "null", "1.#QNAN", "Inf"})
    EXPECT_TRUE(spells_missing(text));
  EXPECT_FALSE(spells_missing("nano"));
}

TEST(ShortestText, AlwaysReadsAsAFloat) {
  EXPECT_EQ(shortest_text(90), "90.0");
  EXPECT_EQ(shortest_text(747.489), "747.489");
  EXPECT_EQ(shortest_text(1e300), "1e+300");
}

TEST(DecimalText, RoundsAndDropsWhatSaysNothing) {
  EXPECT_EQ(decimal_text(12.5, 8), "12.5");
  EXPECT_EQ(decimal_text(-3.0, 8), "-3");
  EXPECT_EQ(decimal_text(100.0, 0), "100");
  EXPECT_EQ(decimal_text(-1e-9, 8), "0");
  EXPECT_EQ(decimal_text(1.23456, 3), "1.235");
}

TEST(DegreesText, GivesBackWhatAPersonTyped) {
  for (const double degrees : {90.0, -89.9683, 0.004, 0.1, 33.3, 360.0, 0.0}) {
    EXPECT_EQ(degrees_text(radians_from_degrees(degrees)), shortest_text(degrees));
  }
}

TEST(ArcsecondsText, GivesBackWhatAPersonTyped) {
  for (const double arcseconds : {2.0, 1.5, 0.1, 20.0, 0.0}) {
    EXPECT_EQ(arcseconds_text(radians_from_arcseconds(arcseconds)), shortest_text(arcseconds));
  }
}

RC_GTEST_PROP(DegreesText, ReadsBackAsTheSameRadians, (std::int64_t whole)) {
  const double x = static_cast<double>(whole) * 0x1.0p-63 * 720.0;
  const double from_degrees = radians_from_degrees(x);
  RC_ASSERT(radians_from_degrees(parse_number(degrees_text(from_degrees)).value()) == from_degrees);
  // Any other radians to within one unit in the last place.
  const double read = radians_from_degrees(parse_number(degrees_text(x)).value());
  RC_ASSERT(std::abs(read - x) <= 2.3e-16 * std::abs(x));
}

TEST(WithPointMoved, KeepsDecimalDigitsAsTheyAre) {
  EXPECT_EQ(with_point_moved(-5.25e-5, 3), -0.0525);
  EXPECT_NE(-5.25e-5 * 1000.0, -0.0525);  // what it is for
  EXPECT_EQ(with_point_moved(0.1273, 3), 127.3);
  EXPECT_EQ(with_point_moved(747.489, -3), 0.747489);
  EXPECT_EQ(with_point_moved(0.0, 3), 0.0);
  EXPECT_EQ(with_point_moved(1e300, 20), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace armcal
