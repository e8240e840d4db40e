// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/objective.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armcal/identification/calibration.h"
#include "armcal/testing/synthetic_readings.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using testing::SyntheticReadings;

struct SeatsAndLength {
  ArmModel nominal = testing::consistent_romer();
  std::vector<ObservationGroup> groups;
};

SyntheticReadings readings(std::uint64_t seed) {
  RandomStream random(seed);
  return {testing::perturbed(testing::consistent_romer(), random, 0.1, 2e-4), seed, 0.005};
}

SeatsAndLength seats_and_length(std::uint64_t seed) {
  SyntheticReadings arm = readings(seed);
  SeatsAndLength bench;
  bench.groups.push_back(arm.fixed_points({"A", "B", "C"}, 20));
  // Rows of one seat need not weigh the same.
  bench.groups[0].u_mm.tail(7).setConstant(0.02);
  bench.groups.push_back(arm.length("A", "B"));
  return bench;
}

/// The objective of what calibrate frees, at what it finds.
struct AtOptimum {
  Calibration calibration;
  double objective = 0.0;
};
AtOptimum at_optimum(const SeatsAndLength& bench) {
  AtOptimum result{calibrate(bench.nominal, bench.groups, {}), 0.0};
  const ArmObjective objective(bench.nominal, bench.groups, result.calibration.free);
  const Eigen::VectorXd values = parameter_values(result.calibration.arm);
  result.objective = objective(values(result.calibration.free));
  return result;
}

// Both add up a few hundred squares of differences of coordinates of 1 m (rounding 1e-13 mm)
// against 5 um: 1e-9 of the sum is far above rounding, far below any mistake.
constexpr double kSame = 1e-9;

TEST(ArmObjective, IsTheChiSquaredOfACalibrationByFixedPointsAndALength) {
  const AtOptimum at = at_optimum(seats_and_length(1));
  ASSERT_TRUE(at.calibration.ok());
  EXPECT_NEAR(at.objective / at.calibration.chi_squared, 1.0, kSame);
}

TEST(ArmObjective, IsTheChiSquaredWhereLengthsShareSeats) {
  SyntheticReadings arm = readings(2);
  SeatsAndLength bench;
  bench.groups.push_back(arm.fixed_points({"A", "B", "C"}, 20));
  bench.groups.push_back(arm.length("A", "B"));
  bench.groups.push_back(arm.length("B", "C"));
  const AtOptimum at = at_optimum(bench);
  ASSERT_TRUE(at.calibration.ok());
  EXPECT_NEAR(at.objective / at.calibration.chi_squared, 1.0, kSame);
}

TEST(ArmObjective, IsTheChiSquaredOfEveryKindOfReference) {
  SyntheticReadings arm = readings(3);
  SeatsAndLength bench;
  bench.groups.push_back(arm.reference_points(40, "A"));
  bench.groups.push_back(arm.fixed_points({"P"}, 20));
  bench.groups.push_back(arm.artefact(4, 6, "plate"));
  bench.groups.push_back(arm.reversals(20));
  bench.groups.push_back(arm.circle_radii(10));
  bench.groups.push_back(arm.sphere(20, 12.5, true));
  bench.groups.push_back(arm.plane(20));
  const AtOptimum at = at_optimum(bench);
  ASSERT_TRUE(at.calibration.ok());
  EXPECT_NEAR(at.objective / at.calibration.chi_squared, 1.0, kSame);
}

TEST(ArmObjective, IsTheSameInClosedFormAndByAFit) {
  SeatsAndLength bench = seats_and_length(4);
  const ParameterTable table(bench.nominal);
  std::vector<int> all;
  for (int i = 0; i < table.size(); ++i) all.push_back(i);
  const ArmObjective closed(bench.nominal, bench.groups, all);
  // An offset of nothing to speak of, and the seats are placed by a fit.
  bench.groups[0].offset_mm.x() = 1e-13;
  const ArmObjective fitted(bench.nominal, bench.groups, all);
  RandomStream random(5);
  for (int trial = 0; trial < 5; ++trial) {
    const Eigen::VectorXd values =
        parameter_values(testing::perturbed(bench.nominal, random, 0.5, 1e-3));
    EXPECT_NEAR(fitted(values) / closed(values), 1.0, kSame);
  }
}

TEST(ArmObjective, IsLeastAtTheOptimumOfLeastSquares) {
  const SeatsAndLength bench = seats_and_length(6);
  const Calibration best = calibrate(bench.nominal, bench.groups, {});
  ASSERT_TRUE(best.ok());
  const ArmObjective objective(bench.nominal, bench.groups, best.free);
  const Eigen::VectorXd at = parameter_values(best.arm)(best.free);
  RandomStream random(7);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::VectorXd aside = at;
    for (double& value : aside) value += 1e-4 * random.normal();
    EXPECT_GT(objective(aside), best.chi_squared);
  }
  EXPECT_GT(objective(objective.start()), 10.0 * best.chi_squared);
}

TEST(ArmObjective, DoesNotCountRowsThatAreHeldOut) {
  SeatsAndLength bench = seats_and_length(8);
  bench.groups[0].is_check[3] = true;
  const double without = at_optimum(bench).objective;
  bench.groups[0].encoder_rad.col(3).setConstant(1.0);
  EXPECT_EQ(at_optimum(bench).objective, without);
}

TEST(ArmObjective, CannotSeeTheSizeOfTheArmInOneSeat) {
  SyntheticReadings arm = readings(9);
  const std::vector<ObservationGroup> groups = {arm.fixed_points({"A"}, 30)};
  const ArmModel nominal = testing::consistent_romer();
  const ParameterTable table(nominal);
  std::vector<int> lengths;
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].unit == ParameterUnit::mm) lengths.push_back(i);
  }
  const ArmObjective objective(nominal, groups, lengths);
  const Eigen::VectorXd half = 0.5 * objective.start();
  EXPECT_NEAR(objective(half) / objective(objective.start()), 0.25, 1e-9);
}

TEST(ArmObjective, RefusesReadingsThatCannotBePlaced) {
  const ArmModel nominal = testing::consistent_romer();
  EXPECT_THROW(ArmObjective(nominal, {}, {0}), std::invalid_argument);
  SyntheticReadings arm = readings(10);
  std::vector<ObservationGroup> groups = {arm.fixed_points({"A", "B"}, 10), arm.length("A", "B")};
  groups[1].place_to[0] = "Z";
  try {
    const ArmObjective objective(nominal, groups, {1});
    FAIL() << "placed a length without its seat";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("needs point.Z"));
  }
}

}  // namespace
}  // namespace armcal
