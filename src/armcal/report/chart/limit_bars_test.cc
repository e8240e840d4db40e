// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/limit_bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

using testing::SvgReader;

LimitBars bars_of(std::vector<LimitBarRow> rows) {
  return {.id = "limits",
          .title = "Limits",
          .nothing = "no tests",
          .as_found = "as found",
          .as_left = "as left",
          .uncertainty = "U",
          .passes = "passes",
          .guarded = "guard",
          .rows = std::move(rows)};
}

LimitBarRow row_of(double value) {
  return {.name = "size error",
          .symbol = "P_Size",
          .limit = "MPE 0.040 mm",
          .mpe = 0.04,
          .is_two_sided = true,
          .guard = 0.006,
          .is_undecided_beyond = true,
          .as_left = LimitedValue{value, 0.006, "the value", "pass", Tone::good}};
}

double mark_at(const SvgReader& svg) {
  const auto marks = svg.root().select_nodes("./circle[@class='as-left']");
  return (marks.end() - 1)->node().attribute("cx").as_double();
}

TEST(LimitBarsDrawings, ValuesStandBetweenTheirLimitsByTheirShares) {
  const double low = mark_at(SvgReader(figure_of(bars_of({row_of(-0.04)})).svg));
  const double zero = mark_at(SvgReader(figure_of(bars_of({row_of(0.0)})).svg));
  const double half = mark_at(SvgReader(figure_of(bars_of({row_of(0.02)})).svg));
  const double high = mark_at(SvgReader(figure_of(bars_of({row_of(0.04)})).svg));
  EXPECT_NEAR(high - zero, zero - low, 0.02);
  EXPECT_NEAR(half - zero, 0.5 * (high - zero), 0.02);
}

TEST(LimitBarsDrawings, AsFoundAndAsLeftStandOnOneBarWithTheirWords) {
  LimitBarRow row = row_of(0.01);
  row.as_found = LimitedValue{-0.05, 0.006, "-0.05 mm", "fail", Tone::bad};
  const SvgReader svg(figure_of(bars_of({row})).svg);
  svg.expect_sound();
  EXPECT_TRUE(svg.says("\u2713 pass"));
  EXPECT_TRUE(svg.says("\u2717 fail"));
  EXPECT_EQ(svg.count("./rect[@class='track']"), 1u);
}

TEST(LimitBarsDrawings, AValueFarBeyondIsAnArrowAtTheEnd) {
  const SvgReader svg(figure_of(bars_of({row_of(4.0), row_of(0.01)})).svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("./path[@class='beyond']"), 1u);
}

TEST(LimitBarsDrawings, OnlyWhatIsDrawnIsInTheLegend) {
  LimitBarRow row = row_of(0.01);
  row.guard = 0.0;
  row.as_left->U = 0.0;
  const SvgReader svg(figure_of(bars_of({row})).svg);
  EXPECT_TRUE(svg.says("as left"));
  EXPECT_FALSE(svg.says("as found"));
  EXPECT_FALSE(svg.says("U"));
  EXPECT_FALSE(svg.says("guard"));
}

TEST(LimitBarsDrawings, DegenerateRowsAreDrawn) {
  EXPECT_TRUE(SvgReader(figure_of(bars_of({})).svg).says("no tests"));
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  LimitBarRow nothing = row_of(kNan);
  LimitBarRow no_limit = row_of(1.0);
  no_limit.mpe = 0.0;
  LimitBarRow no_value{.name = testing::kHostileName, .mpe = 0.1};
  LimitBarRow wide_guard = row_of(0.01);
  wide_guard.guard = 5.0;
  LimitBarRow strange = row_of(1e300);
  strange.as_left->U = std::numeric_limits<double>::infinity();
  strange.guard = kNan;
  strange.mpe = std::numeric_limits<double>::infinity();
  const SvgReader svg(figure_of(bars_of({nothing, no_limit, no_value, wide_guard, strange})).svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("//script"), 0u);
}

}  // namespace
}  // namespace armcal
