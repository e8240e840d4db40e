// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/line.h"

#include <gtest/gtest.h>

#include <limits>

#include "armcal/testing/nist_l2.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/reference_data.h"

namespace armcal {
namespace {

TEST(LineFit, AgreesWithNist) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  auto pairs = testing::nist_pairs("Line3d");
  for (const auto& pair : testing::nist_pairs("Line2d")) pairs.push_back(pair);
  ASSERT_EQ(pairs.size(), 4u);
  for (const auto& pair : pairs) {
    const LineFit fit = fit_line(pair.points);
    ASSERT_TRUE(fit.ok()) << pair.name;
    const Eigen::Vector3d point(pair.fit[0], pair.fit[1], pair.fit[2]);
    const Eigen::Vector3d direction(pair.fit[3], pair.fit[4], pair.fit[5]);
    EXPECT_LT((fit.point_mm - point).norm(), 1e-9) << pair.name;
    EXPECT_LT(fit.direction.cross(direction).norm(), 1e-11) << pair.name;
  }
}

TEST(LineFit, ReportsStraightnessAndRms) {
  const std::vector<Eigen::Vector3d> points = {{-5, 1, 0}, {-5, -1, 0}, {5, 1, 0}, {5, -1, 0}};
  const LineFit fit = fit_line(points);
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR((fit.direction - Eigen::Vector3d::UnitX()).norm(), 0, 1e-15);
  EXPECT_NEAR(fit.rms_mm, 1.0, 1e-15);
  EXPECT_NEAR(fit.form_mm, 2.0, 1e-15);
}

TEST(LineFit, CovarianceIsWhatSimulationShows) {
  RandomStream random(2);
  const double sigma = 0.01;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(10.0 * i, 0.0, 0.0);
  const int trials = 2000;
  double offset = 0.0;
  double slope = 0.0;
  LineFit fit;
  for (int t = 0; t < trials; ++t) {
    fit = fit_line(testing::with_noise(points, sigma, random), {.u_point_mm = sigma});
    offset += fit.point_mm.y() * fit.point_mm.y() / trials;
    slope += fit.direction.z() * fit.direction.z() / trials;
  }
  EXPECT_NEAR(offset / (*fit.covariance)(1, 1), 1.0, 0.13);
  EXPECT_NEAR(slope / (*fit.covariance)(5, 5), 1.0, 0.13);
}

TEST(LineFit, RefusesWithAReason) {
  using V = std::vector<Eigen::Vector3d>;
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fit_line(V{{1, 1, 1}}).status, FitStatus::too_few_points);
  EXPECT_EQ(fit_line(V{{1, 1, 1}, {1, 1, 1}}).status, FitStatus::points_coincide);
  EXPECT_EQ(fit_line(V{{1, 1, 1}, {1, 1, infinity}}).status, FitStatus::not_finite);
}

}  // namespace
}  // namespace armcal
