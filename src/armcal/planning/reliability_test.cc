// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/reliability.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numeric>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/random.h"
#include "armcal/symmetric_point/adjustment.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

Reliability of(const Eigen::MatrixXd& whitened) {
  return reliability(whitened, (whitened.transpose() * whitened).inverse());
}

TEST(Reliability, RedundancyNumbersAddUpToWhatIsLeftOver) {
  RandomStream random(1);
  Eigen::MatrixXd design(12, 5);
  for (double& each : design.reshaped()) each = random.normal();
  EXPECT_NEAR(of(design).redundancy.sum(), 7.0, 1e-9);
}

// What a plan promises is what the adjustment will say of the readings.
TEST(Reliability, AgreesWithTheAdjustment) {
  const ArmModel arm = testing::consistent_romer();
  auto readings = testing::wang2016_readings();
  const ParameterTable table(arm);
  AdjustmentOptions options;
  for (const char* name : {"a5", "a7", "b3", "b5", "b7"}) {
    options.unknowns.push_back(*table.find(name));
  }
  const Adjustment adjustment = adjust(arm, readings, options);
  ASSERT_TRUE(adjustment.ok());
  const Reliability planned =
      of(design_matrix(adjustment.arm, readings)(Eigen::all, adjustment.unknowns));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    const AdjustedReading& reading = adjustment.readings[i];
    EXPECT_NEAR(planned.redundancy(place), reading.redundancy, 1e-9) << reading.name;
    if (!reading.smallest_detectable) continue;
    EXPECT_NEAR(planned.detectable(place) * reading.u / *reading.smallest_detectable, 1.0, 1e-6);
  }
}

// Two readings of one unknown check each other by one test: an error is found, but nobody can say
// in which. A third reading settles it.
TEST(Reliability, TwoReadingsCannotTellWhichOfThemIsWrong) {
  const Reliability two = of(Eigen::MatrixXd::Ones(2, 1));
  EXPECT_NEAR(two.closest(0), 1.0, 1e-12);
  EXPECT_TRUE(std::isfinite(two.detectable(0)));
  EXPECT_GT(two.nameable(0), 1e6);
  const Reliability three = of(Eigen::MatrixXd::Ones(3, 1));
  EXPECT_NEAR(three.closest(0), 0.5, 1e-12);
  EXPECT_LT(three.nameable(0), 10.0);
}

// An error of the nameable size, many times: found and named in all but a thousandth of the cases.
TEST(Reliability, NamesTheErrorThatItPromises) {
  RandomStream random(3);
  Eigen::MatrixXd design(10, 4);
  for (double& each : design.reshaped()) each = random.normal();
  const Eigen::MatrixXd cofactor =
      Eigen::MatrixXd::Identity(10, 10) -
      design * (design.transpose() * design).inverse() * design.transpose();
  const Reliability analysis = of(design);
  constexpr int kTrials = 3000;
  for (const Eigen::Index wrong : {0, 4, 9}) {
    int named = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      Eigen::VectorXd noise(10);
      for (double& each : noise) each = random.normal();
      noise(wrong) += analysis.nameable(wrong);
      const Eigen::VectorXd tests =
          (cofactor * noise).array().abs() / analysis.redundancy.array().sqrt();
      Eigen::Index largest = 0;
      const double most = tests.maxCoeff(&largest);
      named += most > 3.29 && largest == wrong;
    }
    // 99.9 % of each comparison; with nine others at most 0.9 % go wrong.
    EXPECT_GT(named, kTrials * 0.985) << wrong;
  }
}

}  // namespace
}  // namespace armcal
