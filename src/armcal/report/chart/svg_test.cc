// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/svg.h"

#include <gtest/gtest.h>

#include <limits>

#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

TEST(SvgDrawings, CoordinatesAreShort) {
  EXPECT_EQ(coordinate(12.0), "12");
  EXPECT_EQ(coordinate(12.504), "12.5");
  EXPECT_EQ(coordinate(-0.001), "0");
  EXPECT_EQ(coordinate(100.0), "100");
  EXPECT_EQ(coordinate(std::numeric_limits<double>::quiet_NaN()), "0");
  EXPECT_EQ(point(1.04, -0.04), "1 0");
}

TEST(SvgDrawings, TextIsCutBetweenCharactersAndWholeWhenHovered) {
  EXPECT_EQ(shortened("length", 100.0, 13.0), "length");
  const std::string chinese = "\u5173\u8282\u81c2\u6d4b\u91cf\u673a";
  for (double width = 0.0; width < 100.0; width += 3.0) {
    const std::string cut = shortened(chinese, width, 13.0);
    if (cut == chinese) continue;
    EXPECT_EQ((cut.size() - 3) % 3, 0u);
    EXPECT_TRUE(cut.ends_with("\u2026"));
  }
  SvgDrawing drawing(100.0, 50.0);
  drawing.text(0.0, 20.0, "a long <name> of a thing", {.most_width = 50.0});
  const testing::SvgReader svg(drawing.finished("t", "d"));
  EXPECT_STREQ(svg.root().child("text").child("title").text().get(), "a long <name> of a thing");
}

TEST(SvgDrawings, AnyCountOfSeriesHasColours) {
  EXPECT_EQ(series_colour(0), series_colour(6));
  EXPECT_EQ(series_colour(-1), series_colour(5));
}

}  // namespace
}  // namespace armcal
