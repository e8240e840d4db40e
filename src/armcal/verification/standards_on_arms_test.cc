// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/inverse_kinematics.h"
#include "armcal/testing/points_on_sphere.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/sphere_by_subsets.h"
#include "armcal/testing/wang2016_arm.h"
#include "armcal/verification/b89_4_22/effective_diameter.h"
#include "armcal/verification/b89_4_22/single_point_articulation.h"
#include "armcal/verification/b89_4_22/volumetric_length.h"
#include "armcal/verification/iso10360_12/articulated_location.h"
#include "armcal/verification/iso10360_12/length_error_uni.h"
#include "armcal/verification/iso10360_12/probing_form.h"
#include "armcal/verification/iso10360_12/probing_size.h"

// Readings of an arm whose truth is known, put through an arm that is wrong: every statistic must
// be what a second computation makes of the same tips.
namespace armcal {
namespace {

constexpr double kSame_mm = 1e-9;
constexpr ReferenceSphere kCertifiedBall{25.0, 6.0};
using Points = std::vector<Eigen::Vector3d>;

// Off by what an arm may be before it is calibrated.
ArmModel wrong_arm() {
  ArmModel arm = testing::consistent_romer();
  arm.joints[2].zero_rad += 1e-4;
  arm.joints[4].zero_rad -= 3e-4;
  arm.links[2].a_mm += 0.02;
  arm.tip.a_mm += 0.03;
  arm.tip.d_mm -= 0.05;
  return arm;
}

Eigen::VectorXd middle_posture() { return testing::degrees({10, 60, 107, -48, -8, 16}); }

// The true arm goes to each of the points, from a posture about a given one; the tips as the other
// arm sees them.
Points seen(const ArmModel& arm, const Points& targets, double scatter_rad, RandomStream& random,
            const std::vector<int>& joints = {}) {
  const ForwardKinematics truth(testing::consistent_romer());
  const Eigen::VectorXd middle = middle_posture();
  Eigen::MatrixXd postures(6, static_cast<Eigen::Index>(targets.size()));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    PostureSearch search;
    while (!search.found) {
      Eigen::VectorXd start = middle;
      for (double& angle : start) angle += random.uniform(-scatter_rad, scatter_rad);
      search = find_posture(truth, targets[i], start, {.joints = joints});
    }
    postures.col(static_cast<Eigen::Index>(i)) = search.encoder_rad;
  }
  return tips_in_base(arm, postures);
}

Eigen::Vector3d place(double x, double y, double z) { return {x, y, z}; }

struct Ball {
  Eigen::Vector3d center;
  double radius;
  double form;
};

// Gauss-Newton in centre and radius, in extended precision, from the centroid.
Ball ball_through(const Points& points) {
  using Vector4 = Eigen::Matrix<long double, 4, 1>;
  using Matrix4 = Eigen::Matrix<long double, 4, 4>;
  using Vector3 = Eigen::Matrix<long double, 3, 1>;
  Vector4 ball = Vector4::Zero();
  for (const auto& point : points) ball.head<3>() += point.cast<long double>();
  ball /= static_cast<long double>(points.size());
  ball(3) = 15.0L;
  Ball found{};
  for (int iteration = 0; iteration < 100; ++iteration) {
    Matrix4 normal = Matrix4::Zero();
    Vector4 right = Vector4::Zero();
    long double smallest = 1e30L;
    long double largest = 0.0L;
    for (const auto& point : points) {
      const Vector3 from = point.cast<long double>() - ball.head<3>();
      const long double distance = from.norm();
      Vector4 row;
      row << -from / distance, -1.0L;
      normal += row * row.transpose();
      right -= row * (distance - ball(3));
      smallest = std::min(smallest, distance);
      largest = std::max(largest, distance);
    }
    found = {ball.head<3>().cast<double>(), static_cast<double>(ball(3)),
             static_cast<double>(largest - smallest)};
    ball += Vector4(normal.fullPivLu().solve(right));
  }
  return found;
}

TEST(StandardsOnArms, ProbingAgreesWithASecondComputation) {
  RandomStream random(31);
  std::vector<SpherePoints> positions;
  double worst_size = 0.0;
  double worst_form = 0.0;
  for (const auto& center : {place(450, 300, 350), place(-700, 500, 100)}) {
    const Points tips =
        seen(wrong_arm(), testing::points_on_sphere(center, 31.0, 25, 0.0), 0.4, random);
    positions.push_back({std::to_string(positions.size()), tips, ""});
    const Ball ball = ball_through(tips);
    const double size = 2.0 * ball.radius - 31.0;
    if (std::abs(size) > std::abs(worst_size)) worst_size = size;
    worst_form = std::max(worst_form, ball.form);
  }
  const TestResult size = iso10360_12::probing_size(positions, kCertifiedBall);
  const TestResult form = iso10360_12::probing_form(positions, kCertifiedBall);
  EXPECT_NEAR(size.value_mm.value(), worst_size, kSame_mm);
  EXPECT_NEAR(form.value_mm.value(), worst_form, kSame_mm);
  EXPECT_GT(worst_form, 0.01);  // there is something to see
  EXPECT_TRUE(size.complete());
}

TEST(StandardsOnArms, LocationAgreesWithASecondComputation) {
  RandomStream random(32);
  std::vector<SpherePoints> articulations;
  Points centers;
  for (int i = 0; i < 5; ++i) {
    const Points tips = seen(
        wrong_arm(), testing::points_on_sphere(place(450, 300, 350), 31.0, 5, 0.0), 0.6, random);
    articulations.push_back({std::to_string(i + 1), tips, ""});
    centers.push_back(ball_through(tips).center);
  }
  const TestResult result = iso10360_12::articulated_location(articulations, kCertifiedBall);
  EXPECT_NEAR(result.value_mm.value(), 2.0 * testing::radius_by_all_subsets(centers), kSame_mm);
  EXPECT_GT(result.value_mm.value(), 0.01);
}

TEST(StandardsOnArms, ArticulationInSeatsAgreesWithASecondComputation) {
  RandomStream random(33);
  std::vector<b89_4_22::SeatPoints> seats;
  for (const auto& center : {place(120, 150, 200), place(450, 300, 350), place(-1100, 500, 200)}) {
    seats.push_back(
        {std::to_string(seats.size()), seen(wrong_arm(), Points(10, center), 0.5, random), ""});
  }
  const auto results = b89_4_22::single_point_articulation(seats, b89_4_22::reach_of(wrong_arm()));
  ASSERT_EQ(results.size(), 6u);
  for (std::size_t s = 0; s < 3; ++s) {
    const Eigen::Map<const Eigen::Matrix3Xd> tips(seats[s].points_mm.front().data(), 3, 10);
    const Eigen::Matrix3Xd from_mean = tips.colwise() - tips.rowwise().mean().eval();
    EXPECT_NEAR(results[2 * s].value_mm.value(), from_mean.colwise().norm().maxCoeff(), kSame_mm);
    EXPECT_NEAR(results[2 * s + 1].value_mm.value(), 2.0 * from_mean.norm() / 3.0, kSame_mm);
    EXPECT_TRUE(results[2 * s].complete());
  }
}

TEST(StandardsOnArms, AnArmThatIsFarOffIsJudgedAndNotTakenForAnotherSphere) {
  // The tip as the 2016 paper prints it, the wrist held still.
  RandomStream random(36);
  const Eigen::VectorXd middle = middle_posture();
  const Eigen::Vector3d center =
      ForwardKinematics(testing::consistent_romer()).tip_in_base({middle.data(), 6});
  const Points targets = testing::points_on_sphere(center, 31.0, 25, 0.0);
  const Points tips = seen(testing::printed_romer(), targets, 0.0, random, {1, 2, 4});
  const std::vector<SpherePoints> one = {{"1", tips, ""}};
  const TestResult form = iso10360_12::probing_form(one, kCertifiedBall);
  EXPECT_GT(form.value_mm.value(), 1.0);
  EXPECT_TRUE(form.problems.empty()) << form.problems.front();
}

// An arm that takes every length for 0.05 % too long, angles right.
ArmModel stretched(ArmModel arm) {
  constexpr double kScale = 1.0005;
  for (Link& link : arm.links) {
    link.d_mm *= kScale;
    link.b_mm *= kScale;
    link.a_mm *= kScale;
  }
  arm.tip.a_mm *= kScale;
  arm.tip.b_mm *= kScale;
  arm.tip.d_mm *= kScale;
  return arm;
}

TEST(StandardsOnArms, AWrongScaleShowsInLengthsAndNowhereInSeats) {
  RandomStream random(34);
  const ArmModel arm = stretched(testing::consistent_romer());
  const std::vector<b89_4_22::SeatPoints> seats = {
      {"a", seen(arm, Points(10, place(450, 300, 350)), 0.5, random), ""}};
  const auto articulation = b89_4_22::single_point_articulation(seats, {place(0, 0, 0), 1500.0});
  EXPECT_LT(articulation.at(0).value_mm.value(), 1e-8);  // the postures are found to 1e-9 mm
  std::vector<MeasuredLength> lengths;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d middle(300.0, 300.0 + 10.0 * i, 200.0);
    const Eigen::Vector3d half = 0.5 * (300.0 + 10.0 * i) * testing::random_direction(random);
    const Points ends = seen(arm, {middle + half, middle - half}, 0.5, random);
    lengths.push_back({std::to_string(i), 2.0 * half.norm(), (ends[0] - ends[1]).norm(), 0, ""});
  }
  const auto volumetric = b89_4_22::volumetric_length(lengths);
  EXPECT_NEAR(volumetric[0].value_mm.value(), 5e-4 * 490.0, 1e-8);
  for (const ResultPart& part : iso10360_12::length_error_uni(lengths).parts) {
    EXPECT_NEAR(part.value_mm, 5e-4 * part.length_mm.value(), 1e-8);
  }
}

TEST(StandardsOnArms, TheRightArmHasNoErrors) {
  RandomStream random(35);
  std::vector<SpherePoints> fits;
  for (int i = 0; i < 3; ++i) {
    fits.push_back(
        {std::to_string(i + 1),
         seen(testing::consistent_romer(),
              testing::points_on_sphere(place(450, 300, 350), 31.0, 9, 0.0), 0.4, random),
         ""});
  }
  for (const TestResult& result : b89_4_22::effective_diameter(fits, kCertifiedBall)) {
    EXPECT_NEAR(result.value_mm.value(), 0.0, 1e-8) << result.name;
  }
}

}  // namespace
}  // namespace armcal
