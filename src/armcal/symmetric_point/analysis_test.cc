// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

SymmetricPointProcedure paper(double l_PP3) {
  SymmetricPointProcedure procedure;
  procedure.readings = testing::wang2016_readings(l_PP3);
  return procedure;
}

TEST(Analysis, ConsistentReadingsWithoutClaimsAreConsistent) {
  Diagnostics diagnostics;
  const auto analysis =
      analyse_symmetric_points(paper(104.700), testing::nominal_romer(), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value());
  EXPECT_TRUE(analysis->is_consistent());
  EXPECT_TRUE(analysis->leakage_of_chain);
  EXPECT_EQ(analysis->adjustment.unknowns.size(), 5u);  // what the readings solve
  EXPECT_NEAR(analysis->predicted_by_nominal(0), 350.0, 1e-9);
}

TEST(Analysis, SettlesUnknownSignsFirst) {
  SymmetricPointProcedure procedure = paper(104.700);
  procedure.unknown_signs = {"a5", "a7", "direction4", "direction6"};
  Diagnostics diagnostics;
  const auto analysis = analyse_symmetric_points(
      procedure, testing::romer_arm(80, 25, 750, 530, 175, 0), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value());
  EXPECT_EQ(analysis->signs.size(), 16u);
  EXPECT_EQ(analysis->nominal.tip.a_mm, -25.0);
  EXPECT_NEAR(analysis->adjustment.arm.links[3].a_mm, 78.312, 0.001);
}

TEST(Analysis, HoldsASecondArmAgainstTheReadings) {
  Diagnostics diagnostics;
  const auto analysis = analyse_symmetric_points(paper(104.070), testing::nominal_romer(),
                                                 testing::printed_romer(), diagnostics);
  ASSERT_TRUE(analysis.has_value());
  EXPECT_FALSE(analysis->is_consistent());
  EXPECT_EQ(analysis->claims.size(), 6u);
  EXPECT_GT(std::abs(analysis->predicted_by_compared(2) - 104.070), 300.0);
}

TEST(Analysis, PatternsChooseWhatIsEstimated) {
  SymmetricPointProcedure procedure = paper(104.700);
  procedure.unknowns = {"a*", "b*"};
  procedure.hold = {"a2", "a3", "a4", "a6", "b2", "b4", "b6"};
  Diagnostics diagnostics;
  const auto analysis =
      analyse_symmetric_points(procedure, testing::nominal_romer(), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value());
  EXPECT_EQ(analysis->adjustment.unknowns.size(), 5u);
}

TEST(Analysis, WarnsOfAReadingThatScattersFarMoreThanItsLike) {
  // Two repeats at one end and one at the other: nothing within the reading can tell.
  SymmetricPointProcedure procedure = paper(104.700);
  procedure.readings.resize(5);
  for (SymmetricReading& reading : procedure.readings) {
    const double off = reading.name == "l_PP2" ? 0.4 : 0.002;
    reading.reduced = false;
    reading.u = 0.001;
    reading.raw = RawSymmetricPoints{.file = reading.name + ".csv"};
    for (const double x : {0.0, off, reading.value + off / 2}) {
      reading.raw->points_mm.emplace_back(x, 0, 0);
      reading.raw->end.push_back(reading.raw->end.size() < 2 ? 'A' : 'B');
      reading.raw->lines.push_back(static_cast<int>(reading.raw->end.size()) + 1);
    }
  }
  Diagnostics diagnostics;
  ASSERT_TRUE(analyse_symmetric_points(procedure, testing::nominal_romer(), {}, diagnostics));
  ASSERT_EQ(diagnostics.entries().size(), 1u) << diagnostics.to_text();
  EXPECT_THAT(diagnostics.to_text(),
              ::testing::HasSubstr("l_PP2.csv: warning: reading \"l_PP2\" scatters far more"));
}

// The documented default used to ask for nothing, and found that nothing is determined.
TEST(Analysis, WithoutSolvesEverythingThatTheReadingsDetermineIsEstimated) {
  SymmetricPointProcedure procedure = paper(104.700);
  for (SymmetricReading& reading : procedure.readings) reading.solves.clear();
  Diagnostics diagnostics;
  const auto analysis =
      analyse_symmetric_points(procedure, testing::nominal_romer(), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value());
  ASSERT_TRUE(analysis->adjustment.ok());
  EXPECT_LE(analysis->adjustment.unknowns.size(), 6u);
  EXPECT_NEAR(analysis->adjustment.arm.links[3].a_mm, 78.312, 0.02);
  EXPECT_NEAR(analysis->adjustment.arm.links[1].b_mm, 747.489, 0.02);
  const auto& names = analysis->adjustment.unknown_names;
  for (const char* name : {"a5", "a7", "b3", "b5", "b7"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(Analysis, ReadingsThatTellNothingApartBreakTheChainAndNothingElse) {
  SymmetricPointProcedure procedure;
  for (const char* solves : {"b7", "a7"}) {
    procedure.readings.push_back(testing::circle_radius(
        std::string("r of ") + solves, 6, testing::degrees({0, 0, 0, 0, 0, 0}), 178.383));
    procedure.readings.back().solves = solves;
  }
  Diagnostics diagnostics;
  const auto analysis =
      analyse_symmetric_points(procedure, testing::nominal_romer(), {}, diagnostics);
  ASSERT_TRUE(analysis.has_value());
  EXPECT_TRUE(analysis->adjustment.ok());
  EXPECT_FALSE(analysis->chain->complete);
  EXPECT_FALSE(analysis->leakage_of_chain);
  EXPECT_EQ(analysis->leakage.recovered.size(), 1u);  // of the adjustment, which holds one side
}

}  // namespace
}  // namespace armcal
