// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/interval_chart.h"

#include <gtest/gtest.h>

#include <limits>

#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

using testing::SvgReader;

IntervalChart chart_of(std::vector<IntervalGroup> groups) {
  return {.id = "changes",
          .title = "Changes",
          .nothing = "nothing estimated",
          .estimated = "estimated",
          .held = "held",
          .groups = std::move(groups)};
}

TEST(IntervalCharts, RowsOfAGroupShareAScaleAndHeldOnesAreHollow) {
  const SvgReader svg(
      figure_of(
          chart_of(
              {{"mm",
                {{"d1", 1.0, 0.5, "1.0"}, {"d2", -1.0, 0.5, "-1.0"}, {"d3", 0.0, 0.0, "", true}}}}))
          .svg);
  svg.expect_sound();
  const auto estimated = svg.root().select_nodes("./circle[@class='s0']");
  const auto held = svg.root().select_nodes("./circle[@class='held']");
  ASSERT_EQ(estimated.size(), 3u);  // one in the legend
  ASSERT_EQ(held.size(), 2u);
  const double zero = held[1].node().attribute("cx").as_double();
  EXPECT_NEAR(estimated[1].node().attribute("cx").as_double() - zero,
              zero - estimated[2].node().attribute("cx").as_double(), 0.02);
}

TEST(IntervalCharts, FortyRowsAndHostileOnesAreDrawn) {
  IntervalGroup group{"mrad", {}};
  for (int i = 0; i < 40; ++i) group.rows.push_back({"zero", 0.1 * i, 1.0, "x"});
  group.rows.push_back({testing::kHostileName, std::numeric_limits<double>::quiet_NaN(), 1.0, "?"});
  group.rows.push_back({"far", 1e308, std::numeric_limits<double>::infinity(), ""});
  group.rows.push_back({"farther", -1e308, 1e308, ""});
  const Figure figure = figure_of(chart_of({group, {"empty", {}}}));
  const SvgReader svg(figure.svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("//script"), 0u);
  EXPECT_LT(figure.svg.size(), 40000u);
}

TEST(IntervalCharts, NothingIsSaidInWords) {
  EXPECT_TRUE(SvgReader(figure_of(chart_of({{"mm", {}}})).svg).says("nothing estimated"));
}

}  // namespace
}  // namespace armcal
