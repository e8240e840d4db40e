// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "armcal/core/random.h"
#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

using testing::SvgReader;

HeatMap random_map(Eigen::Index rows, Eigen::Index columns) {
  RandomStream random(3);
  HeatMap map{.id = "correlation", .title = "Correlation", .nothing = "no parameters"};
  map.values.resize(rows, columns);
  for (double& value : map.values.reshaped()) value = random.uniform(-1.0, 1.0);
  for (Eigen::Index i = 0; i < rows; ++i) map.rows.push_back("a" + std::to_string(i));
  for (Eigen::Index i = 0; i < columns; ++i) map.columns.push_back("b" + std::to_string(i));
  return map;
}

TEST(HeatMaps, EveryCellOfASmallOneSaysItsValueAndItsNames) {
  const SvgReader svg(figure_of(random_map(4, 6)).svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("./path/title"), 24u);
  EXPECT_EQ(svg.count(".//text[@class='value']"), 24u);
}

TEST(HeatMaps, ALargeOneStaysSmallAndNamesItsStrongestCells) {
  const HeatMap map = random_map(60, 60);
  const Figure figure = figure_of(map);
  EXPECT_TRUE(figure.is_wide);
  EXPECT_LT(figure.svg.size(), 240000u);  // 3600 cells, none of them near zero
  const SvgReader svg(figure.svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("./path/title"), 400u);
}

TEST(HeatMaps, SignsCanBeReadWithoutColours) {
  HeatMap map = random_map(20, 20);
  map.values.setConstant(-0.5);
  const auto dashes = SvgReader(figure_of(map).svg).starts("./path[@class='cell-sign']").size();
  map.values.setConstant(0.5);
  const auto crosses = SvgReader(figure_of(map).svg).starts("./path[@class='cell-sign']").size();
  EXPECT_EQ(dashes, 400u);
  EXPECT_EQ(crosses, 800u);
}

TEST(HeatMaps, CellsWeakerThanAskedForHaveNeitherNumberNorSign) {
  HeatMap small = random_map(1, 4);
  small.values << 1.0, -0.021, 0.019, 0.0;
  small.least_marked = 0.02;
  const SvgReader numbers(figure_of(small).svg);
  EXPECT_EQ(numbers.count(".//text[@class='value']"), 2u);
  EXPECT_EQ(numbers.count("./path/title"), 4u);  // hovering tells them all
  HeatMap large = random_map(20, 20);
  large.values.setConstant(-0.019);
  large.values(0, 0) = 1.0;
  large.values(3, 4) = -0.021;
  large.least_marked = 0.02;
  // A plus and a dash.
  EXPECT_EQ(SvgReader(figure_of(large).svg).starts("./path[@class='cell-sign']").size(), 3u);
}

TEST(HeatMaps, CellsThatAreNotFiniteStayBlank) {
  HeatMap map = random_map(3, 3);
  map.values(1, 1) = std::numeric_limits<double>::quiet_NaN();
  map.values(2, 0) = -std::numeric_limits<double>::infinity();
  const SvgReader svg(figure_of(map).svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("./path/title"), 7u);
}

TEST(HeatMaps, DegenerateOnesAreDrawn) {
  EXPECT_TRUE(SvgReader(figure_of(random_map(0, 0)).svg).says("no parameters"));
  HeatMap zeros = random_map(2, 3);
  zeros.values.setZero();
  SvgReader(figure_of(zeros).svg).expect_sound();
  HeatMap unnamed = random_map(2, 3);
  unnamed.rows.clear();
  unnamed.columns = {testing::kHostileName};
  unnamed.largest = std::numeric_limits<double>::quiet_NaN();
  const SvgReader svg(figure_of(unnamed).svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("//script"), 0u);
}

}  // namespace
}  // namespace armcal
