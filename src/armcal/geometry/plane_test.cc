// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "armcal/testing/nist_l2.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/reference_data.h"

namespace armcal {
namespace {

using testing::random_direction;
using testing::random_normal_vector;

TEST(PlaneFit, AgreesWithNist) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  const auto pairs = testing::nist_pairs("Plane");
  ASSERT_EQ(pairs.size(), 30u);
  for (const auto& pair : pairs) {
    const PlaneFit fit = fit_plane(pair.points);
    ASSERT_TRUE(fit.ok()) << pair.name;
    const Eigen::Vector3d point(pair.fit[0], pair.fit[1], pair.fit[2]);
    const Eigen::Vector3d normal(pair.fit[3], pair.fit[4], pair.fit[5]);
    EXPECT_LT((fit.point_mm - point).norm(), 1e-9) << pair.name;
    EXPECT_LT(fit.normal.cross(normal).norm(), 1e-10) << pair.name;
  }
}

TEST(PlaneFit, ReportsFlatnessAndRms) {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 1}, {10, 0, -1}, {0, 10, -1}, {10, 10, 1}};
  const PlaneFit fit = fit_plane(points);
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR((fit.normal - Eigen::Vector3d::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR(fit.rms_mm, 1.0, 1e-15);
  EXPECT_NEAR(fit.form_mm, 2.0, 1e-15);
  EXPECT_EQ(fit.degrees_of_freedom, 1);
  // One residual of 2 mm in all (sum of squares 4), one degree of freedom: variance 4, offset 4/4.
  EXPECT_NEAR(fit.standard_uncertainty("z").value(), 1.0, 1e-14);
}

TEST(PlaneFit, HoldsFarFromTheOrigin) {
  RandomStream random(1);
  const Eigen::Vector3d normal = random_direction(random);
  const auto [u, v] = perpendicular_pair(normal);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20; ++i) {
    points.push_back(Eigen::Vector3d(1e6, -1e6, 1e6) + random.uniform(-50, 50) * u +
                     random.uniform(-50, 50) * v);
  }
  const PlaneFit fit = fit_plane(points);
  ASSERT_TRUE(fit.ok());
  // Coordinates of 1e6 mm are rounded to 1e-10 mm; over 50 mm that turns the normal by 1e-11.
  EXPECT_LT(fit.normal.cross(normal).norm(), 1e-11);
}

TEST(PlaneFit, CovarianceIsWhatSimulationShows) {
  RandomStream random(2);
  const double sigma = 0.01;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 12; ++i) {
    points.emplace_back(random.uniform(-30, 30), random.uniform(-10, 10), 0.0);
  }
  const int trials = 2000;
  double offset = 0.0;
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  PlaneFit fit;
  for (int t = 0; t < trials; ++t) {
    fit = fit_plane(testing::with_noise(points, sigma, random), {.u_point_mm = sigma});
    offset += fit.point_mm.z() * fit.point_mm.z() / trials;
    tilt += fit.normal.head<2>().cwiseAbs2() / trials;
  }
  // The variance of a variance from 2000 trials is 3.2 %; four of these.
  EXPECT_NEAR(offset / (*fit.covariance)(2, 2), 1.0, 0.13);
  EXPECT_NEAR(tilt.x() / (*fit.covariance)(3, 3), 1.0, 0.13);
  EXPECT_NEAR(tilt.y() / (*fit.covariance)(4, 4), 1.0, 0.13);
}

TEST(PlaneFit, ThreePointsHaveNoScatterToJudgeBy) {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const PlaneFit fit = fit_plane(points);
  EXPECT_TRUE(fit.ok());
  EXPECT_FALSE(fit.covariance.has_value());
  EXPECT_TRUE(fit_plane(points, {.u_point_mm = 0.001}).covariance.has_value());
}

TEST(PlaneFit, RefusesWithAReason) {
  using V = std::vector<Eigen::Vector3d>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fit_plane(V{}).status, FitStatus::too_few_points);
  EXPECT_EQ(fit_plane(V{{0, 0, 0}, {1, 0, 0}}).status, FitStatus::too_few_points);
  EXPECT_EQ(fit_plane(V{{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}, {2.1, 2.2, 2.3}}).status,
            FitStatus::points_are_collinear);
  EXPECT_EQ(fit_plane(V{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}).status, FitStatus::points_coincide);
  EXPECT_EQ(fit_plane(V{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}).status, FitStatus::not_finite);
}

}  // namespace
}  // namespace armcal
