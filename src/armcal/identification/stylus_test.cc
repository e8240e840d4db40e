// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/stylus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/inverse_kinematics.h"
#include "armcal/core/units.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

constexpr double kTouchNoise_mm = 0.01;

// The tip of an arm in one seat, in postures that joints take freely.
ObservationGroup in_a_seat(const ArmModel& arm, int count, std::vector<int> free_joints,
                           std::uint64_t seed) {
  const ForwardKinematics kinematics(arm);
  RandomStream random(seed);
  const Eigen::VectorXd start = testing::degrees({10, 60, 107, -48, -8, 16});
  const Eigen::Vector3d seat_mm = kinematics.tip_in_base(as_span(start));
  ObservationGroup group;
  group.name = "seat";
  group.kind = ReferenceKind::fixed_point;
  group.encoder_rad.resize(6, 0);
  while (group.count() < count) {
    Eigen::VectorXd near = start;
    for (const int joint : free_joints) near(joint - 1) += random.uniform(-1.5, 1.5);
    const Eigen::Vector3d target = seat_mm + kTouchNoise_mm * testing::random_normal_vector(random);
    const PostureSearch search = find_posture(kinematics, target, near, {.joints = {1, 2, 4}});
    if (!search.found) continue;
    group.encoder_rad.conservativeResize(6, group.encoder_rad.cols() + 1);
    group.encoder_rad.rightCols(1) = search.encoder_rad;
    group.lines.push_back(static_cast<int>(group.lines.size()) + 2);
  }
  group.is_check.assign(group.lines.size(), false);
  group.place.assign(group.lines.size(), "seat");
  group.u_mm = Eigen::VectorXd::Constant(count, kTouchNoise_mm);
  return group;
}

ArmModel with_other_stylus(ArmModel arm) {
  arm.tip.a_mm += 3.0;
  arm.tip.b_mm -= 20.0;
  arm.tip.d_mm += 1.0;
  return arm;
}

TEST(Stylus, IsFoundWithinItsUncertainty) {
  const ArmModel truth = with_other_stylus(testing::consistent_romer());
  const auto readings = in_a_seat(truth, 15, {3, 5, 6}, 1);
  const auto stylus = qualify_stylus(testing::consistent_romer(), readings);
  ASSERT_TRUE(stylus.calibration.ok());
  EXPECT_TRUE(stylus.undetermined().empty());
  const std::array<double, 3> wanted = {truth.tip.a_mm, truth.tip.b_mm, truth.tip.d_mm};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(stylus.tip[k].value_mm, wanted[k], 4.0 * stylus.tip[k].u_mm);
    EXPECT_NEAR(stylus.tip[k].u_mm,
                std::sqrt(stylus.covariance_mm2(static_cast<int>(k), static_cast<int>(k))), 1e-12);
    EXPECT_LE(2.0 * stylus.tip[k].u_mm, stylus.U_mm + 1e-12);  // the worst direction
  }
  EXPECT_NEAR(stylus.change_mm, std::sqrt(9.0 + 400.0 + 1.0), stylus.U_mm);
  EXPECT_GT(stylus.change_in_u, 100.0);
}

TEST(Stylus, ThatIsTheOldOneMovesByChanceOnly) {
  int beyond = 0;
  constexpr int kTrials = 40;
  for (std::uint64_t seed = 0; seed < kTrials; ++seed) {
    const auto stylus = qualify_stylus(testing::consistent_romer(),
                                       in_a_seat(testing::consistent_romer(), 8, {3, 5, 6}, seed));
    ASSERT_TRUE(stylus.calibration.ok());
    beyond += stylus.change_in_u > 2.795 ? 1 : 0;
  }
  EXPECT_LE(beyond, 7);  // 5 % of 40 are 2, four standard deviations of 1.4 more
}

TEST(Stylus, OfAStillWristIsNotDetermined) {
  const auto stylus = qualify_stylus(testing::consistent_romer(),
                                     in_a_seat(testing::consistent_romer(), 10, {}, 3));
  EXPECT_EQ(stylus.undetermined().size(), 3u);
  for (const TipCoordinate& each : stylus.tip) EXPECT_LT(each.swing_rad, 0.02);
}

TEST(Stylus, SwingsAreAnglesFromTheMeanDirection) {
  // Only the last joint turns, by +-40 deg: x and y of its frame swing by that, z stays.
  Eigen::MatrixXd postures(6, 3);
  for (int i = 0; i < 3; ++i) postures.col(i) = testing::degrees({10, 60, 107, -48, -8, 16});
  postures(5, 0) -= radians_from_degrees(40.0);
  postures(5, 2) += radians_from_degrees(40.0);
  const Eigen::Vector3d swings = swings_of_last_joint(testing::consistent_romer(), postures);
  EXPECT_NEAR(degrees_from_radians(swings(0)), 40.0, 1e-9);
  EXPECT_NEAR(degrees_from_radians(swings(1)), 40.0, 1e-9);
  EXPECT_NEAR(swings(2), 0.0, 1e-7);
  // Half a turn apart there is no mean direction.
  postures.conservativeResize(6, 2);
  postures(5, 1) = postures(5, 0) + std::numbers::pi;
  EXPECT_NEAR(swings_of_last_joint(testing::consistent_romer(), postures)(0), std::numbers::pi,
              1e-9);
}

}  // namespace
}  // namespace armcal
