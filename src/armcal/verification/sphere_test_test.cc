// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/sphere_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "armcal/arm/inverse_kinematics.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

constexpr double kCertified = 15.8754;

PostureSearch with_tip_at(const ForwardKinematics& kinematics, const Eigen::Vector3d& point_mm,
                          const std::vector<double>& start, std::vector<int> joints) {
  const Eigen::Map<const Eigen::VectorXd> start_rad(start.data(), 6);
  return find_posture(kinematics, point_mm, start_rad, {.joints = std::move(joints)});
}

// Joint angles of an arm that touches points spread over the upper half of a sphere about `center`,
// from each of the postures in turn: joints 1, 2 and the elbow, 4, bring the tip to the points
// while 3, 5 and 6 stay.
JointReadings touched(const ArmModel& arm, const Eigen::Vector3d& center, double distance_mm,
                      const std::vector<std::vector<double>>& postures, int points_per_posture) {
  const ForwardKinematics kinematics(arm);
  RandomStream random(3);
  JointReadings readings;
  for (const auto& posture : postures) {
    for (int i = 0; i < points_per_posture; ++i) {
      Eigen::Vector3d direction = testing::random_direction(random);
      direction.z() = std::abs(direction.z());
      const Eigen::Vector3d target = center + distance_mm * direction;
      const PostureSearch search = with_tip_at(kinematics, target, posture, {1, 2, 4});
      EXPECT_TRUE(search.found);
      readings.encoder_rad.conservativeResize(6, readings.encoder_rad.cols() + 1);
      readings.encoder_rad.rightCols(1) = search.encoder_rad;
    }
  }
  return readings;
}

// In this posture the wrong tip of the printed arm all but cancels in the diameter.
std::vector<double> still_wrist() {
  const Eigen::VectorXd angles = testing::degrees({10, 60, 107, -48, -8, 16});
  return {angles.data(), angles.data() + 6};
}

Eigen::Vector3d center_of_sphere() {
  return ForwardKinematics(testing::consistent_romer()).tip_in_base(still_wrist());
}

// Five very different postures with the tip on the same point.
std::vector<std::vector<double>> five_articulations() {
  const ForwardKinematics kinematics(testing::consistent_romer());
  RandomStream random(5);
  std::vector<std::vector<double>> postures;
  while (postures.size() < 5) {
    std::vector<double> start;
    for (int i = 0; i < 6; ++i) start.push_back(random.uniform(-2.5, 2.5));
    const PostureSearch search = with_tip_at(kinematics, center_of_sphere(), start, {1, 2, 3, 4});
    if (search.found && std::abs(search.encoder_rad(3)) > 0.5) {
      postures.emplace_back(search.encoder_rad.begin(), search.encoder_rad.end());
    }
  }
  return postures;
}

TEST(SphereTest, RightArmFindsTheCertifiedDiameter) {
  const ArmModel arm = testing::consistent_romer();
  const double tip_diameter = 6.0;
  const auto readings =
      touched(arm, center_of_sphere(), (kCertified + tip_diameter) / 2, five_articulations(), 10);
  const SphereTest test = test_sphere(arm, readings, {kCertified, tip_diameter, {}, {}});
  ASSERT_TRUE(test.ok());
  EXPECT_NEAR(test.diameter_error_mm, 0.0, 1e-8);
  EXPECT_NEAR(test.form_error_mm.value(), 0.0, 1e-8);
  EXPECT_NEAR(test.uncompensated_error_mm, tip_diameter, 1e-8);
  EXPECT_EQ(test.verdict(), Verdict::not_judged);
}

TEST(SphereTest, PrintedArmPassesByDiameterAndFailsByForm) {
  // Finding of the recomputation: with the wrist held still the published set misses the diameter
  // by about 0.1 mm only, but the form by millimetres.
  const auto readings =
      touched(testing::consistent_romer(), center_of_sphere(), kCertified / 2, {still_wrist()}, 25);
  const SphereTest test =
      test_sphere(testing::printed_romer(), readings, {kCertified, 0.0, 0.15, 0.1});
  ASSERT_TRUE(test.ok());
  EXPECT_LT(std::abs(test.diameter_error_mm), 0.15);
  EXPECT_GT(test.form_error_mm.value(), 1.0);
  EXPECT_EQ(test.diameter_verdict, Verdict::pass);
  EXPECT_EQ(test.form_verdict, Verdict::fail);
  EXPECT_EQ(test.verdict(), Verdict::fail);
}

TEST(SphereTest, WarnsWhereAStillWristHidesErrors) {
  const ArmModel arm = testing::consistent_romer();
  const SphereTest still =
      test_sphere(arm, touched(arm, center_of_sphere(), kCertified / 2, {still_wrist()}, 25),
                  {kCertified, 0.0, {}, {}});
  EXPECT_GT(still.blind_spots.size(), 5u);
  EXPECT_LT(still.joint_spans_rad(5), 1e-9);
  const SphereTest articulated =
      test_sphere(arm, touched(arm, center_of_sphere(), kCertified / 2, five_articulations(), 5),
                  {kCertified, 0.0, {}, {}});
  EXPECT_EQ(articulated.blind_spots.size(), 0u)
      << articulated.blind_spots.front().parameter << " " << articulated.blind_spots.front().shown;
}

TEST(SphereTest, BlindSpotsAreWhatAnErrorReallyShows) {
  const ArmModel arm = testing::consistent_romer();
  const auto readings = touched(arm, center_of_sphere(), kCertified / 2, {still_wrist()}, 25);
  const SphereTest before = test_sphere(arm, readings, {kCertified, 0.0, {}, {}});
  for (const BlindSpot& spot : before.blind_spots) {
    if (spot.parameter != "b3") continue;
    ArmModel wrong = arm;
    wrong.links[1].b_mm += 1.0;
    const SphereTest after = test_sphere(wrong, readings, {kCertified, 0.0, {}, {}});
    EXPECT_NEAR(std::max(after.form_error_mm.value(), std::abs(after.diameter_error_mm)),
                spot.shown, 0.1 * spot.shown + 1e-4);
  }
}

TEST(SphereTest, ReproducesThePapersRelativeError) {
  // 15.8145 mm against 15.8754 mm is 0.3836 %.
  PointReadings readings;
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0),
        Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0, 0, 1)}) {
    readings.points_mm.push_back(15.8145 / 2 * direction);
  }
  const SphereTest test = test_sphere(readings, {kCertified, 0.0, 0.07, {}});
  EXPECT_NEAR(100 * std::abs(test.relative_error), 0.3836, 5e-5);
  EXPECT_NEAR(test.diameter_error_mm, -0.0609, 1e-9);
  EXPECT_EQ(test.verdict(), Verdict::pass);
  EXPECT_TRUE(test.blind_spots.empty());
}

TEST(SphereTest, RefusesWhatIsNoSphere) {
  PointReadings readings;
  for (int i = 0; i < 6; ++i) readings.points_mm.emplace_back(i, i * i, 0.0);
  EXPECT_EQ(test_sphere(readings, {kCertified, 0.0, {}, {}}).fit.status,
            FitStatus::points_are_coplanar);
  EXPECT_THROW(static_cast<void>(test_sphere(readings, {-1.0, 0.0, {}, {}})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(test_sphere(readings, {1.0, -1.0, {}, {}})),
               std::invalid_argument);
}

}  // namespace
}  // namespace armcal
