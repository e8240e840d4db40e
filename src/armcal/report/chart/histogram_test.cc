// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "armcal/core/random.h"
#include "armcal/numerics/distributions.h"
#include "armcal/testing/svg_reader.h"

namespace armcal {
namespace {

std::vector<double> normal_values(int count, double scale = 1.0) {
  RandomStream random(7);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(scale * random.normal());
  return values;
}

TEST(Histograms, EveryFiniteValueIsInOneBin) {
  for (const int count : {1, 2, 3, 10, 1000}) {
    for (const double scale : {1e-12, 1.0, 1e9}) {
      std::vector<double> values = normal_values(count, scale);
      values.push_back(std::numeric_limits<double>::quiet_NaN());
      values.push_back(std::numeric_limits<double>::infinity());
      const HistogramBins bins = histogram_bins(values);
      ASSERT_EQ(bins.edges.size(), bins.counts.size() + 1);
      EXPECT_LE(bins.counts.size(), 60u);
      EXPECT_EQ(std::accumulate(bins.counts.begin(), bins.counts.end(), 0.0), count);
    }
  }
}

TEST(Histograms, BinsOfNormalValuesAreAboutAsWideAsFreedmanAndDiaconisHaveThem) {
  const HistogramBins bins = histogram_bins(normal_values(1000));
  // 2 * 1.349 / 10 = 0.27, rounded up to a nice width.
  EXPECT_NEAR(bins.edges[1] - bins.edges[0], 0.5, 1e-12);
}

TEST(Histograms, AValueFarAwayDoesNotHideTheOthers) {
  std::vector<double> values = normal_values(100);
  values.push_back(1e9);
  const HistogramBins bins = histogram_bins(values);
  EXPECT_LT(bins.edges.back(), 10.0);
  EXPECT_EQ(bins.counts.back(), 1.0);
  EXPECT_EQ(bins.beyond, 1U);
  EXPECT_EQ(histogram_bins(normal_values(100)).beyond, 0U);
}

TEST(Histograms, DegenerateValuesHaveBinsToo) {
  EXPECT_TRUE(histogram_bins({}).counts.empty());
  const std::vector<double> equal(20, 3.0);
  EXPECT_EQ(histogram_bins(equal).counts.size(), 1u);
  const std::vector<double> huge = {-1e308, 1e308, 1e300, 5.0, -1e300};
  EXPECT_LE(histogram_bins(huge).counts.size(), 60u);
}

// Bins much wider than 1, or far from 0, had a curve that was flat or not there.
TEST(Histograms, StepsAreWhatANormalDistributionPutsIntoEachBin) {
  for (const double scale : {0.1, 1.0, 25.0}) {
    const HistogramBins bins = histogram_bins(normal_values(500, scale));
    const Chart chart = with_histogram({.id = "h"}, "residuals", "as stated", bins);
    ASSERT_EQ(chart.series.size(), 2u);
    const ChartSeries& steps = chart.series[1];
    EXPECT_EQ(steps.mark, Mark::steps);
    ASSERT_EQ(steps.x, bins.edges);
    ASSERT_EQ(steps.y.size(), steps.x.size());
    for (std::size_t i = 0; i < bins.counts.size(); ++i) {
      const double share = normal_cdf(bins.edges[i + 1]) - normal_cdf(bins.edges[i]);
      EXPECT_NEAR(steps.y[i], 500.0 * share, 1e-9);
    }
    testing::SvgReader(figure_of(chart).svg).expect_sound();
  }
}

TEST(QuantilePlots, TheBandHoldsAboutTheShareThatItSays) {
  int inside = 0;
  int all = 0;
  for (int trial = 0; trial < 60; ++trial) {
    RandomStream random(static_cast<std::uint64_t>(trial) + 100);
    std::vector<double> values;
    for (int i = 0; i < 15; ++i) values.push_back(random.normal());
    const Chart chart = with_normal_quantiles({}, {"r", "d", "b"}, values);
    const auto& points = chart.series[0];
    const auto& low = chart.series[2];
    const auto& high = chart.series[3];
    ASSERT_EQ(low.x, points.x);  // so few that the band has every order
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      inside += points.y[i] > low.y[i] && points.y[i] < high.y[i] ? 1 : 0;
      ++all;
    }
  }
  // Neighbouring order statistics move together: the scatter of the share is about 0.013.
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.04);
}

TEST(QuantilePlots, AValueFarAwayDoesNotHideTheOthers) {
  std::vector<double> values = normal_values(100);
  values.push_back(1e9);
  const ChartSeries points = with_normal_quantiles({}, {"r", "d", "b"}, values).series[0];
  ASSERT_EQ(points.y.size(), 100U);
  EXPECT_LT(points.y.back(), 10.0);
  // The 100th of 101, not of 100: what is not drawn still counts.
  EXPECT_NEAR(points.x.back(), normal_quantile((100.0 - 0.375) / 101.25), 1e-12);
}

TEST(QuantilePlots, OneValueAndThousandsAreDrawn) {
  for (const int count : {0, 1, 2, 5000}) {
    const Chart chart = with_normal_quantiles({.id = "q"}, {"r", "d", "b"}, normal_values(count));
    const Figure figure = figure_of(chart);
    testing::SvgReader(figure.svg).expect_sound();
    EXPECT_LT(figure.svg.size(), 60000u);
  }
}

}  // namespace
}  // namespace armcal
