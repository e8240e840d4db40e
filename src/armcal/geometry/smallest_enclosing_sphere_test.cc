// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/smallest_enclosing_sphere.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>

#include "armcal/testing/random_geometry.h"
#include "armcal/testing/sphere_by_subsets.h"

namespace armcal {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using testing::cover_radius;
using testing::radius_by_all_subsets;

// No other centre does better: from any, some point that holds the sphere is farther away.
void expect_smallest_about(const Points& points, RandomStream& random) {
  const EnclosingSphere sphere = smallest_enclosing_sphere(points);
  ASSERT_DOUBLE_EQ(cover_radius(sphere.center_mm, points), sphere.radius_mm);
  ASSERT_GE(sphere.support.size(), 1u);
  ASSERT_LE(sphere.support.size(), 4u);
  const double scale = sphere.radius_mm + 1e-9;
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector3d step =
        std::pow(10.0, -random.uniform(0.0, 6.0)) * scale * testing::random_direction(random);
    ASSERT_GT(cover_radius(sphere.center_mm + step, points), sphere.radius_mm * (1.0 - 1e-14));
  }
}

TEST(SmallestEnclosingSphere, HoldsOneTwoAndThreePointsAsByHand) {
  const EnclosingSphere one = smallest_enclosing_sphere(Points{{1, 2, 3}});
  EXPECT_EQ(one.radius_mm, 0.0);
  EXPECT_EQ(one.center_mm, Eigen::Vector3d(1, 2, 3));
  const EnclosingSphere two = smallest_enclosing_sphere(Points{{0, 0, 0}, {6, 8, 0}});
  EXPECT_NEAR(two.radius_mm, 5.0, 1e-15);
  // A right angle lies on the circle over its hypotenuse; an obtuse one inside.
  EXPECT_NEAR(smallest_enclosing_sphere(Points{{0, 0, 0}, {6, 0, 0}, {0, 8, 0}}).radius_mm, 5.0,
              1e-14);
  EXPECT_NEAR(smallest_enclosing_sphere(Points{{-5, 0, 0}, {5, 0, 0}, {1, 2, 0}}).radius_mm, 5.0,
              1e-14);
  // Equilateral triangle of side 1: 1/sqrt(3). Regular tetrahedron of edge sqrt(8): sqrt(3).
  const double height = std::sqrt(0.75);
  EXPECT_NEAR(smallest_enclosing_sphere(Points{{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}).radius_mm,
              1.0 / std::sqrt(3.0), 1e-15);
  const EnclosingSphere four =
      smallest_enclosing_sphere(Points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  EXPECT_NEAR(four.radius_mm, std::sqrt(3.0), 1e-15);
  EXPECT_EQ(four.support.size(), 4u);
}

TEST(SmallestEnclosingSphere, TakesEqualCollinearAndCoplanarPoints) {
  const Points equal(7, Eigen::Vector3d(1e3, -2e3, 5.0));
  EXPECT_EQ(smallest_enclosing_sphere(equal).radius_mm, 0.0);
  Points line;
  for (int i = 0; i <= 10; ++i) line.emplace_back(i, 2.0 * i, -2.0 * i);
  EXPECT_NEAR(smallest_enclosing_sphere(line).radius_mm, 15.0, 1e-13);
  Points ring;
  for (int i = 0; i < 360; ++i) ring.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 4.0);
  EXPECT_NEAR(smallest_enclosing_sphere(ring).radius_mm, 1.0, 1e-14);
}

TEST(SmallestEnclosingSphere, SeesWhatIsHardlyOutside) {
  // The third point lies outside the sphere of the other two by x, the answer is larger by x^2 /
  // 2r.
  for (const double x : {1e-4, 1e-7, 1e-9, 1e-12}) {
    const Points points = {{-10, 0, 0}, {10, 0, 0}, {0, 10 + x, 0}};
    EXPECT_NEAR(smallest_enclosing_sphere(points).radius_mm, std::hypot(10.0, x), 1e-12) << x;
  }
}

TEST(SmallestEnclosingSphere, AgreesWithAllSubsetsOfFour) {
  RandomStream random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const auto count = 1 + random.below(8);
    const double size = std::pow(10.0, random.uniform(-3.0, 3.0));
    const Eigen::Vector3d place = 1000.0 * testing::random_direction(random);
    Points points;
    for (std::uint64_t i = 0; i < count; ++i) {
      points.push_back(place + testing::random_normal_vector(random, size));
    }
    EXPECT_NEAR(smallest_enclosing_sphere(points).radius_mm, radius_by_all_subsets(points), 1e-9);
  }
}

TEST(SmallestEnclosingSphere, ThousandsOfPointsOnASphereGiveIt) {
  RandomStream random(12);
  Points points;
  const Eigen::Vector3d center(200, -300, 400);
  for (int i = 0; i < 5000; ++i)
    points.push_back(center + 12.7 * testing::random_direction(random));
  const EnclosingSphere sphere = smallest_enclosing_sphere(points);
  EXPECT_NEAR(sphere.radius_mm, 12.7, 1e-9);
  EXPECT_LT((sphere.center_mm - center).norm(), 1e-3);  // rounding decides which points hold it
}

RC_GTEST_PROP(SmallestEnclosingSphereOfAnything, ContainsAllAndIsSmallest, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
  const int count = *rc::gen::inRange(1, 40);
  const bool on_grid = *rc::gen::arbitrary<bool>();  // many equal, cospherical, coplanar ones
  Points points;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d point = testing::random_normal_vector(random, 2.0);
    if (on_grid) point = point.array().round();
    points.push_back(point);
  }
  expect_smallest_about(points, random);
}

RC_GTEST_PROP(SmallestEnclosingSphereOfAnything, MovesWithItsPoints, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
  const RigidTransform motion = testing::random_transform(random, 100.0);
  Points points;
  Points moved;
  for (int i = 0; i < 12; ++i) {
    points.push_back(testing::random_normal_vector(random, 5.0));
    moved.push_back(motion * points.back());
  }
  RC_ASSERT(std::abs(smallest_enclosing_sphere(points).radius_mm -
                     smallest_enclosing_sphere(moved).radius_mm) < 1e-11);
}

TEST(SmallestEnclosingSphere, RefusesWhatHasNoAnswer) {
  EXPECT_THROW(static_cast<void>(smallest_enclosing_sphere({})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(smallest_enclosing_sphere(Points{{1, NAN, 0}})),
               std::invalid_argument);
}

}  // namespace
}  // namespace armcal
