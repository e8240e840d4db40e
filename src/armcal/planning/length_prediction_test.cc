// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/length_prediction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/core/random.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

TEST(LengthPrediction, IsTheErrorOfArmsDrawnFromTheCovariance) {
  const ArmModel arm = testing::consistent_romer();
  const ParameterTable table(arm);
  const std::vector<int> unknowns = {*table.find("b3"), *table.find("zero4"),
                                     *table.find("alpha5")};
  Eigen::Matrix3d factor;
  factor << 0.01, 0, 0, 1e-6, 1e-5, 0, -1e-6, 5e-6, 2e-5;
  const auto pairs = random_pairs(arm, {}, 60, 5);
  const double predicted =
      predicted_length_error_mm(arm, unknowns, factor * factor.transpose(), pairs);
  RandomStream random(9);
  double sum = 0.0;
  constexpr int kArms = 400;
  for (int i = 0; i < kArms; ++i) {
    const Eigen::Vector3d error =
        factor * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    Eigen::VectorXd values = table.nominal();
    values(unknowns) += error;
    sum += std::pow(length_error_mm(with_parameter_values(arm, values), arm, pairs), 2);
  }
  // 400 arms of three parameters: the root mean square is good to 3 %.
  EXPECT_NEAR(std::sqrt(sum / kArms) / predicted, 1.0, 0.1);
}

TEST(LengthPrediction, PairsKeepToLimitsAndVolume) {
  ArmModel arm = testing::consistent_romer();
  arm.joints[1].min_rad = 0.5;
  arm.joints[1].max_rad = 0.7;
  HalfTurnRoom room;
  room.volume = MeasuringVolume{{-2000, -2000, 0}, {2000, 2000, 2000}};
  for (const PosturePair& pair : random_pairs(arm, room, 50, 1)) {
    EXPECT_FALSE(obstacle(arm, room, pair.first_rad));
    EXPECT_FALSE(obstacle(arm, room, pair.second_rad));
  }
  room.volume = MeasuringVolume{{5000, 5000, 0}, {6000, 6000, 10}};
  EXPECT_THROW(static_cast<void>(random_pairs(arm, room, 1, 1)), ImpossiblePlan);
}

TEST(LengthPrediction, TheSameArmHasNoError) {
  const ArmModel arm = testing::consistent_romer();
  EXPECT_EQ(length_error_mm(arm, arm, random_pairs(arm, {}, 10, 1)), 0.0);
}

}  // namespace
}  // namespace armcal
