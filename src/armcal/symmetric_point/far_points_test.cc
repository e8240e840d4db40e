// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/far_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "armcal/testing/random_geometry.h"

namespace armcal {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points repeats(std::size_t count, RandomStream& random) {
  return testing::with_noise(Points(count, Eigen::Vector3d(900, -300, 400)), 0.002, random);
}

Points arc(int count, double span_rad, RandomStream& random) {
  const RigidTransform pose = testing::random_transform(random, 500.0);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double t = span_rad * i / (count - 1);
    points.push_back(pose * Eigen::Vector3d(180 * std::cos(t), 180 * std::sin(t), 0));
  }
  return testing::with_noise(points, 0.002, random);
}

// One repeat 10 mm off used to be averaged in silence.
TEST(FarPoints, ABlunderAmongRepeatsIsNamed) {
  RandomStream random(1);
  for (const std::size_t count : {3u, 4u, 6u}) {
    const Points a = repeats(count, random);
    Points b = repeats(count, random);
    b[1].y() += 10.0;
    const auto far = far_repeats(a, b);
    ASSERT_EQ(far.size(), 1u) << count;
    EXPECT_EQ(far[0].index, count + 1);
    EXPECT_NEAR(far[0].distance_mm, 10.0, 0.02);
    EXPECT_LT(far[0].usual_mm, 0.01);
  }
}

TEST(FarPoints, OfTwoRepeatsBothAreNamed) {
  RandomStream random(2);
  const Points a = repeats(2, random);
  Points b = repeats(2, random);
  b[0].x() += 10.0;
  const auto far = far_repeats(a, b);
  ASSERT_EQ(far.size(), 2u);
  EXPECT_EQ(far[0].index, 2u);
  EXPECT_EQ(far[1].index, 3u);
  // Nothing tells how far off is far where only one end was repeated, once.
  EXPECT_TRUE(far_repeats(b, Points(1, Eigen::Vector3d::Zero())).empty());
  EXPECT_TRUE(far_repeats(Points(1, Eigen::Vector3d::Zero()), Points{}).empty());
}

TEST(FarPoints, GoodRepeatsAreLeftInPeace) {
  RandomStream random(3);
  int called = 0;
  const int trials = 4000;
  for (int t = 0; t < trials; ++t) {
    called += far_repeats(repeats(3, random), repeats(3, random)).empty() ? 0 : 1;
  }
  EXPECT_LE(called, trials / 500);
  // Nor do equal repeats make the last digit a blunder.
  Points same(5, Eigen::Vector3d(1, 2, 3));
  same[4].x() += 0.001;
  EXPECT_TRUE(far_repeats(same, same).empty());
}

TEST(FarPoints, ABlunderOnAnArcIsNamedHoweverShortTheArc) {
  RandomStream random(4);
  for (const double span : {1.0, 3.0, 5.5}) {
    for (const int count : {7, 9, 18}) {
      Points points = arc(count, span, random);
      points[2] += 10.0 * testing::random_direction(random);
      const auto far = far_points_of_arc(points);
      ASSERT_EQ(far.size(), 1u) << count << " points over " << span;
      EXPECT_EQ(far[0].index, 2u);
    }
  }
}

TEST(FarPoints, TwoBlundersOnAnArcAreBothNamed) {
  RandomStream random(5);
  Points points = arc(18, 5.5, random);
  points[2].x() += 3.0;
  points[11].z() -= 1.0;
  const auto far = far_points_of_arc(points);
  ASSERT_EQ(far.size(), 2u);
  EXPECT_EQ(far[0].index + far[1].index, 13u);
}

TEST(FarPoints, GoodArcsAreLeftInPeace) {
  RandomStream random(6);
  int called = 0;
  for (int t = 0; t < 500; ++t) called += far_points_of_arc(arc(9, 4.0, random)).empty() ? 0 : 1;
  EXPECT_EQ(called, 0);
  EXPECT_TRUE(far_points_of_arc(arc(6, 4.0, random)).empty());
}

}  // namespace
}  // namespace armcal
