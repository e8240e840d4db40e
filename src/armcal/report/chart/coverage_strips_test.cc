// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/coverage_strips.h"

#include <gtest/gtest.h>

#include <limits>

#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

using testing::SvgReader;

CoverageStrips strips_of(std::vector<JointStrip> joints) {
  return {.id = "coverage",
          .title = "Coverage",
          .nothing = "no readings",
          .axis = "encoder, deg",
          .fit = "fit",
          .check = "check",
          .span = "covered",
          .joints = std::move(joints)};
}

TEST(CoverageStripsDrawings, SayHowMuchOfAJointTheFitCovers) {
  const SvgReader svg(
      figure_of(strips_of({{"joint 1", -180.0, 180.0, {-90.0, 30.0, 0.0}, {-170.0}}})).svg);
  svg.expect_sound();
  EXPECT_TRUE(svg.says("120\u00b0"));
  EXPECT_EQ(svg.starts("./path[@class='s0' and starts-with(@d, 'M')]").size(), 3u);
}

TEST(CoverageStripsDrawings, StrangeAnglesAndNamesAreDrawn) {
  const double endless = std::numeric_limits<double>::infinity();
  JointStrip strange{testing::kHostileName, endless, -endless, {1e300, endless, 5.0}, {}};
  strange.check_deg = {std::numeric_limits<double>::quiet_NaN(), 5.0};
  const SvgReader svg(figure_of(strips_of({strange, {"none"}})).svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("//script"), 0u);
  EXPECT_TRUE(SvgReader(figure_of(strips_of({})).svg).says("no readings"));
  EXPECT_TRUE(SvgReader(figure_of(strips_of({{"none"}})).svg).says("no readings"));
}

TEST(ReachedPointsViews, AreFromAboveAndFromTheSideAtEqualScales) {
  ReachedPoints points{.id = "volume", .x = "x, mm", .y = "y, mm", .z = "z, mm", .fit = "fit"};
  points.fit_mm.resize(3, 2);
  points.fit_mm << 1, 4, 2, 5, 3, 6;
  const auto charts = views_of(points);
  ASSERT_EQ(charts.size(), 2u);
  EXPECT_EQ(charts[0].id, "volume-top");
  EXPECT_EQ(charts[1].id, "volume-side");
  EXPECT_TRUE(charts[0].equal_scales && charts[1].equal_scales);
  ASSERT_EQ(charts[0].series.size(), 1u);
  EXPECT_EQ(charts[0].series[0].y, (std::vector<double>{2, 5}));
  EXPECT_EQ(charts[1].series[0].y, (std::vector<double>{3, 6}));
}

}  // namespace
}  // namespace armcal
