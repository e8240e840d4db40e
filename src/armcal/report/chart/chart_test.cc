// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "armcal/core/random.h"
#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

using testing::kHostileName;
using testing::SvgReader;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Chart chart_of(std::vector<ChartSeries> series) {
  return {.id = "residuals",
          .title = "Residuals",
          .text = "Every reading",
          .x = {.label = "reach, mm"},
          .y = {.label = "residual, mm"},
          .series = std::move(series),
          .nothing = "no readings"};
}

ChartSeries scattered(Mark mark, int style, int count) {
  RandomStream random(static_cast<std::uint64_t>(style) + 1);
  ChartSeries series{.name = "fit", .mark = mark, .style = style};
  for (int i = 0; i < count; ++i) {
    series.x.push_back(random.uniform(300.0, 1200.0));
    series.y.push_back(0.03 * random.normal());
  }
  return series;
}

TEST(Charts, EveryFinitePointIsDrawnInsideTheFrameAndNoOther) {
  for (int style = 0; style < 12; ++style) {
    ChartSeries series = scattered(Mark::dots, style, 30);
    series.x[3] = kNan;
    series.y[7] = kInfinity;
    series.y.pop_back();
    const SvgReader svg(figure_of(chart_of({series})).svg);
    svg.expect_sound();
    // One is the sample in the legend; a plus or cross is two strokes, of which one is moved to.
    EXPECT_EQ(svg.starts("./path[starts-with(@class, 'dots')]").size(), 28u) << style;
  }
}

TEST(Charts, MarksStandWhereTheirNumbersAre) {
  const ChartSeries series{.style = 0, .x = {0.0, 10.0, 5.0}, .y = {0.0, 1.0, 0.5}};
  const SvgReader svg(figure_of(chart_of({series})).svg);
  const auto at = svg.starts("./path[starts-with(@class, 'dots')]");
  ASSERT_EQ(at.size(), 3u);
  EXPECT_LT(at[0].x, at[1].x);
  EXPECT_GT(at[0].y, at[1].y);
  EXPECT_NEAR(at[2].x, 0.5 * (at[0].x + at[1].x), 0.11);
  EXPECT_NEAR(at[2].y, 0.5 * (at[0].y + at[1].y), 0.11);
}

TEST(Charts, EqualScalesDrawAMillimetreAsLongEitherWay) {
  for (const double tall : {0.1, 1.0, 7.0}) {
    Chart chart = chart_of({{.x = {0.0, 100.0}, .y = {0.0, 100.0 * tall}}});
    chart.equal_scales = true;
    const auto at = SvgReader(figure_of(chart).svg).starts("./path[starts-with(@class, 'dots')]");
    ASSERT_EQ(at.size(), 2u);
    EXPECT_NEAR((at[0].y - at[1].y) / (at[1].x - at[0].x), tall, 0.02 * tall);
  }
}

TEST(Charts, ALineEndsWhereAValueIsMissing) {
  const ChartSeries series{.mark = Mark::line, .x = {0, 1, 2, 3, 4}, .y = {0, 1, kNan, 1, 0}};
  const SvgReader svg(figure_of(chart_of({series})).svg);
  EXPECT_EQ(svg.starts("./path[starts-with(@class, 'line')]").size(), 2u);
}

TEST(Charts, BarsStandOnZeroAndAnEmptyOneIsNotDrawn) {
  const ChartSeries series{.mark = Mark::bars, .x = {0, 1, 2, 3}, .y = {4, 0, 2}};
  const SvgReader svg(figure_of(chart_of({series})).svg);
  const auto at = svg.starts("./path[starts-with(@class, 'bars')]");
  ASSERT_EQ(at.size(), 2u);
  EXPECT_EQ(at[0].y, at[1].y);
  EXPECT_TRUE(svg.says("0"));
}

TEST(Charts, EmptyDataAreSaidInWords) {
  for (const auto& series :
       {std::vector<ChartSeries>{}, {{.x = {kNan}, .y = {1.0}}}, {{.x = {1.0}}}}) {
    const Figure figure = figure_of(chart_of(series));
    const SvgReader svg(figure.svg);
    svg.expect_sound();
    EXPECT_TRUE(svg.says("no readings"));
    EXPECT_EQ(figure.live, "");
  }
}

TEST(Charts, SurviveWhatNumbersThereAre) {
  const double values[] = {-1e308, -1.0, 0.0, 1e-310, 1.0, 1e308, kNan, kInfinity};
  for (const double a : values) {
    for (const double b : values) {
      for (const Mark mark : {Mark::dots, Mark::line, Mark::steps, Mark::bars}) {
        Chart chart = chart_of({{.mark = mark, .x = {a, b, 3.0}, .y = {b, a, 2.0}}});
        chart.lines = {{false, a, "limit", Tone::bad}, {true, b, "limit", Tone::neutral}};
        chart.y.scale = a > 0.0 ? AxisScale::logarithmic : AxisScale::linear;
        SvgReader(figure_of(chart).svg).expect_sound();
      }
    }
  }
}

TEST(Charts, NamesFromOutsideAreTextAndNothingElse) {
  ChartSeries series = scattered(Mark::dots, 0, 3);
  series.name = kHostileName;
  series.labels = {kHostileName, "\xff\xfe", "b"};
  Chart chart = chart_of({series});
  chart.title = chart.text = chart.x.label = chart.y.label = kHostileName;
  chart.lines = {{false, 0.0, kHostileName, Tone::bad}};
  const Figure figure = figure_of(chart);
  const SvgReader svg(figure.svg);
  svg.expect_sound();
  EXPECT_EQ(svg.count("//script"), 0u);
  EXPECT_EQ(nlohmann::json::parse(figure.live)["series"][0]["labels"].size(), 3u);
}

TEST(Charts, AThousandPointsStaySmall) {
  for (int style = 0; style < 12; ++style) {
    const Figure figure = figure_of(chart_of({scattered(Mark::dots, style, 1000)}));
    EXPECT_LT(figure.svg.size(), 40000u) << style;
    EXPECT_LT(figure.live.size(), 40000u);
  }
}

TEST(Charts, LimitsAreNamedInTheirToneBesideTheData) {
  Chart chart = chart_of({scattered(Mark::dots, 0, 100)});
  chart.lines = {{false, 0.04, "MPE", Tone::bad}, {false, 0.04, "the same", Tone::neutral}};
  const SvgReader svg(figure_of(chart).svg);
  EXPECT_EQ(svg.count("./path[@class='limit bad']"), 1u);
  EXPECT_TRUE(svg.says("MPE"));
  const auto y_of = [&](const char* text) {
    const std::string xpath = std::string("./text[.='") + text + "']";
    return svg.root().select_node(xpath.c_str()).node().attribute("y").as_double();
  };
  EXPECT_NE(y_of("MPE"), y_of("the same"));
}

TEST(Charts, TellAScriptTheSameInSixDigits) {
  Chart chart = chart_of({{.name = "fit", .style = 2, .x = {1.23456789, kNan}, .y = {-2e-9, 1.0}}});
  chart.y.scale = AxisScale::logarithmic;
  chart.x.low = 0.0;
  chart.series[0].y[0] = 2e-9;
  chart.lines = {{true, 0.5, "word", Tone::warning}};
  const auto live = nlohmann::json::parse(figure_of(chart).live);
  EXPECT_EQ(live["kind"], "chart");
  EXPECT_EQ(live["x"]["low"], 0.0);
  EXPECT_TRUE(live["x"]["high"].is_null());
  EXPECT_EQ(live["y"]["scale"], "log");
  EXPECT_EQ(live["equal"], false);
  EXPECT_EQ(live["series"][0]["mark"], "dots");
  EXPECT_EQ(live["series"][0]["style"], 2);
  EXPECT_EQ(live["series"][0]["x"][0], 1.23457);
  EXPECT_TRUE(live["series"][0]["x"][1].is_null());
  EXPECT_FALSE(live["series"][0].contains("labels"));
  EXPECT_EQ(live["lines"][0]["tone"], "warning");
  EXPECT_EQ(live["lines"][0]["vertical"], true);
}

}  // namespace
}  // namespace armcal
