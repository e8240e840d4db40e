// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/probed_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "armcal/testing/points_on_sphere.h"

namespace armcal {
namespace {

using testing::points_on_sphere;

const Eigen::Vector3d kCenter(400.0, -300.0, 250.0);

SpherePoints probed(double diameter_mm, double scale = 1.0) {
  SpherePoints set{.name = "A", .points_mm = points_on_sphere(kCenter, diameter_mm, 25)};
  for (Eigen::Vector3d& point : set.points_mm) point *= scale;
  return set;
}

std::string problem(const SpherePoints& points, const ReferenceSphere& sphere) {
  return probe_sphere(points, sphere, "position").problem.value_or("none");
}

TEST(ProbedSphere, TakesTheProbeOff) {
  const ProbedSphere found = probe_sphere(probed(25.4 + 6.0 + 0.013), {25.4, 6.0}, "position");
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found.problem.has_value());
  EXPECT_NEAR(found.diameter_error_mm, 0.013, 1e-11);
  EXPECT_NEAR(found.diameter_mm, 25.413, 1e-11);
}

TEST(ProbedSphere, NamesOtherUnits) {
  EXPECT_EQ(problem(probed(31.4, 1.0 / 25.4), {25.4, 6.0}),
            "position A: the centres of the probe lie on a sphere of 1.2362 mm where 31.4000 mm is "
            "expected: 25.4 times too small, as if in inches");
  EXPECT_NE(problem(probed(31.4, 1e-3), {25.4, 6.0}).find("as if in metres"), std::string::npos);
  EXPECT_NE(problem(probed(31.4, 0.1), {25.4, 6.0}).find("as if in centimetres"),
            std::string::npos);
  EXPECT_NE(problem(probed(31.4, 1e3), {25.4, 6.0}).find("1000 times too large"),
            std::string::npos);
}

TEST(ProbedSphere, NamesAnotherSphere) {
  EXPECT_EQ(problem(probed(36.0), {25.4, 6.0}),
            "position A: the points lie on a sphere of 30.0000 mm, 25.4000 mm is certified: "
            "another sphere?");
  EXPECT_EQ(problem(probed(25.4), {25.4, 6.0}),
            "position A: the points lie on a sphere of 19.4000 mm, 25.4000 mm is certified: off by "
            "the diameter of the probe; are the points of the surface already?");
  EXPECT_EQ(problem(probed(26.39), {25.4, 0.0}), "none");  // 0.99 mm may be an arm
  EXPECT_NE(problem(probed(26.41), {25.4, 0.0}), "none");
  EXPECT_NE(problem(probed(5.51), {5.0, 0.0}), "none");  // a tenth of a small sphere
}

TEST(ProbedSphere, DoesNotBlameTheSphereForABadArm) {
  // Stretched by a tenth in one direction: the diameter is off by about 1 mm, the form by more.
  SpherePoints stretched = probed(25.4);
  for (Eigen::Vector3d& point : stretched.points_mm) {
    point.x() += 0.12 * (point.x() - kCenter.x());
  }
  const ProbedSphere found = probe_sphere(stretched, {25.4, 0.0}, "position");
  EXPECT_GT(std::abs(found.diameter_error_mm), 0.9);
  EXPECT_GT(found.fit.form_mm, std::abs(found.diameter_error_mm));
  EXPECT_FALSE(found.problem.has_value()) << *found.problem;
}

TEST(ProbedSphere, SeesThatUnitsAreMixed) {
  SpherePoints mixed = probed(25.4);
  for (std::size_t i = 0; i < 12; ++i) mixed.points_mm[i] /= 25.4;
  EXPECT_NE(problem(mixed, {25.4, 0.0}), "none");
}

TEST(ProbedSphere, GivesTheFitsReasonToRefuse) {
  SpherePoints ring = probed(25.4);
  for (Eigen::Vector3d& point : ring.points_mm) point.z() = 0.0;
  EXPECT_EQ(problem(ring, {25.4, 0.0}), "position A: the points lie in one plane");
  ring.points_mm.resize(3);
  EXPECT_EQ(problem(ring, {25.4, 0.0}), "position A: there are too few points");
  SpherePoints hole = probed(25.4);
  hole.points_mm[3].x() = NAN;
  EXPECT_EQ(problem(hole, {25.4, 0.0}), "position A: a coordinate is not a finite number");
}

TEST(ProbedSphere, RefusesNonsense) {
  EXPECT_THROW(static_cast<void>(probe_sphere(probed(25.4), {0.0, 6.0}, "position")),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(probe_sphere(probed(25.4), {25.4, -6.0}, "position")),
               std::invalid_argument);
}

}  // namespace
}  // namespace armcal
