// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "armcal/core/random.h"
#include "armcal/report/chart/svg.h"
#include "armcal/report/document.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

bool is_nice(double step) {
  const double exponent = std::floor(std::log10(step) + 1e-9);
  const double factor = step / std::pow(10.0, exponent);
  return std::abs(factor - 1.0) < 1e-6 || std::abs(factor - 2.0) < 1e-6 ||
         std::abs(factor - 5.0) < 1e-6;
}

TEST(ChartScale, LinearTicksAreEvenNiceAndWithinTheRange) {
  RandomStream random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const double magnitude = std::pow(10.0, random.uniform(-12.0, 12.0));
    const double low = magnitude * random.normal();
    const double high = low + magnitude * random.uniform(0.01, 3.0);
    const auto ticks = ChartScale(AxisScale::linear, {low, high}, 0.0, 400.0).ticks(6);
    ASSERT_GE(ticks.size(), 2u) << low << " " << high;
    EXPECT_LE(ticks.size(), 12u);
    const double step = ticks[1].value - ticks[0].value;
    EXPECT_TRUE(is_nice(step)) << step;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_GE(ticks[i].value, low);
      EXPECT_LE(ticks[i].value, high);
      if (i == 0) continue;
      EXPECT_NEAR(ticks[i].value - ticks[i - 1].value, step, 1e-6 * step);
      EXPECT_NE(ticks[i].text, ticks[i - 1].text);
    }
  }
}

// The live charts are held against the same table (web/report/test/ticks.test.mjs).
TEST(ChartScale, HasTheMarksOfTheTable) {
  const Json cases =
      Json::parse(testing::read_bytes(testing::repository() / "web/report/test/tick_cases.json"));
  ASSERT_GE(cases.size(), 9U);
  for (const Json& each : cases) {
    const AxisScale kind = each["scale"] == "log" ? AxisScale::logarithmic : AxisScale::linear;
    const ChartScale scale(kind, {each["low"], each["high"]}, 0.0, 400.0);
    const std::vector<ChartTick> ticks = scale.ticks(each["about"].get<int>());
    ASSERT_EQ(ticks.size(), each["ticks"].size()) << each;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      const double wanted = each["ticks"][i][0];
      EXPECT_NEAR(ticks[i].value, wanted, 1e-9 * std::abs(wanted)) << each;
      EXPECT_EQ(ticks[i].text, each["ticks"][i][1]) << each;
    }
  }
}

TEST(ChartScale, LogarithmicTicksAreDecadesAndWithinTheRange) {
  RandomStream random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const double low = std::pow(10.0, random.uniform(-20.0, 10.0));
    const double high = low * std::pow(10.0, random.uniform(0.05, 20.0));
    const auto ticks = ChartScale(AxisScale::logarithmic, {low, high}, 0.0, 400.0).ticks(6);
    EXPECT_GE(ticks.size(), 2u) << low << " " << high;
    EXPECT_LE(ticks.size(), 70u);
    for (const ChartTick& tick : ticks) {
      EXPECT_GE(tick.value, low);
      EXPECT_LE(tick.value, high);
    }
  }
}

TEST(ChartScale, MapsEndsToEndsAndWhatIsBeyondToTheEnd) {
  const ChartScale linear(AxisScale::linear, {-2.0, 6.0}, 300.0, 20.0);
  EXPECT_DOUBLE_EQ(linear.at(-2.0), 300.0);
  EXPECT_DOUBLE_EQ(linear.at(6.0), 20.0);
  EXPECT_DOUBLE_EQ(linear.at(2.0), 160.0);
  EXPECT_DOUBLE_EQ(linear.at(1e300), 20.0);
  const ChartScale decades(AxisScale::logarithmic, {1e-3, 1e3}, 0.0, 60.0);
  EXPECT_NEAR(decades.at(1.0), 30.0, 1e-9);
  EXPECT_DOUBLE_EQ(decades.at(0.0), 0.0);
}

TEST(ChartScale, NumbersHaveATrueMinusAndPowersAreShort) {
  EXPECT_EQ(signed_text(-2.5, 1), "\u22122.5");
  EXPECT_EQ(signed_text(-0.001, 1), "0.0");
  EXPECT_EQ(power_text(1, -3), "0.001");
  EXPECT_EQ(power_text(1, -6), "10\u207b\u2076");
  EXPECT_EQ(power_text(2, -12), "2\u00d710\u207b\u00b9\u00b2");
  EXPECT_EQ(power_text(5, 2), "500");
  const auto small = ChartScale(AxisScale::linear, {0.0, 3e-9}, 0.0, 400.0).ticks(4);
  EXPECT_EQ(small[0].text, "0");
  EXPECT_EQ(small[1].text, "1\u00d710\u207b\u2079");
}

TEST(ChartScale, TextsBelowAnAxisDoNotMeetAndStayEven) {
  RandomStream random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const double low = random.uniform(-1e4, 1e4);
    const ChartScale scale(AxisScale::linear, {low, low + std::pow(10.0, random.uniform(-4, 4))},
                           50.0, 460.0);
    const auto ticks = scale.ticks_below(9, 13.0);
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      const double way = scale.at(ticks[i].value) - scale.at(ticks[i - 1].value);
      const double widths = text_width(ticks[i].text + ticks[i - 1].text, 13.0);
      EXPECT_GE(way, 0.5 * widths);
      EXPECT_FALSE(ticks[i].text.empty());
    }
  }
}

TEST(ChartScale, AnAxisOfAnyDataHasALengthThatCanBeDivided) {
  const double values[] = {0.0,   1.0,    -1.0, 500.0,    1e-300,      1e300,    -1e308,
                           1e308, 1e-310, 1e15, 1e15 + 1, kNotANumber, kInfinite};
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
    for (const double a : values) {
      for (const double b : values) {
        const double both[] = {a, b};
        const ChartRange range = axis_range({.scale = scale}, range_of(both, scale));
        EXPECT_LT(range.low, range.high) << a << " " << b;
        EXPECT_TRUE(std::isfinite(range.high - range.low));
        EXPECT_TRUE(scale == AxisScale::linear || range.low > 0.0);
        const ChartScale drawn(scale, range, 0.0, 100.0);
        EXPECT_LE(drawn.ticks(5).size(), 70u);
      }
    }
  }
}

TEST(ChartScale, EndsThatAnAxisHasAtLeastAreWidenedByDataOnly) {
  const ChartAxis axis{.low = 0.0, .high = 10.0};
  const ChartRange inside = axis_range(axis, ChartRange{2.0, 3.0});
  EXPECT_EQ(inside.low, 0.0);
  EXPECT_EQ(inside.high, 10.0);
  const ChartRange beyond = axis_range(axis, ChartRange{2.0, 30.0});
  EXPECT_EQ(beyond.low, 0.0);
  EXPECT_GT(beyond.high, 30.0);
  const ChartRange alone = axis_range(axis, {});
  EXPECT_EQ(alone.low, 0.0);
  EXPECT_EQ(alone.high, 10.0);
}

}  // namespace
}  // namespace armcal
