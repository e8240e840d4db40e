// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/nist_l2.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/reference_data.h"

namespace armcal {
namespace {

using testing::random_direction;

// Points evenly at random on a cap of the given half angle about `pole`, computed in long double so
// that only the rounding of the coordinates themselves is left.
std::vector<Eigen::Vector3d> cap(const Eigen::Vector3d& center, double radius,
                                 const Eigen::Vector3d& pole, double half_angle_rad, int count,
                                 RandomStream& random) {
  using Long = long double;
  const auto [u, v] = perpendicular_pair(pole);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Long polar = half_angle_rad * std::sqrt(static_cast<Long>(random.uniform()));
    const Long around = 2.0L * std::numbers::pi_v<Long> * random.uniform();
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) {
      const Long direction = std::cos(polar) * static_cast<Long>(pole(k)) +
                             std::sin(polar) * (std::cos(around) * static_cast<Long>(u(k)) +
                                                std::sin(around) * static_cast<Long>(v(k)));
      // The basis is orthonormal to double rounding only; its error is part of the sphere, not of
      // the fit.
      point(k) = static_cast<double>(static_cast<Long>(center(k)) + radius * direction);
    }
    points.push_back(point);
  }
  return points;
}

TEST(SphereFit, AgreesWithNist) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  const auto pairs = testing::nist_pairs("Sphere");
  ASSERT_EQ(pairs.size(), 30u);
  for (const auto& pair : pairs) {
    const SphereFit fit = fit_sphere(pair.points);
    ASSERT_TRUE(fit.ok()) << pair.name << " " << to_string(fit.status);
    const Eigen::Vector3d center(pair.fit[0], pair.fit[1], pair.fit[2]);
    EXPECT_LT((fit.center_mm - center).norm(), 1e-9) << pair.name;
    EXPECT_NEAR(2.0 * fit.radius_mm, pair.fit[3], 1e-9) << pair.name;
  }
}

TEST(SphereFit, ReachesWhatTheDataAllow) {
  // Full spheres, caps down to 1 deg, radii from a stylus to a dish, near and a kilometre away. The
  // error must stay within what the rounding of the coordinates does, propagated by the fit's own
  // covariance.
  RandomStream random(7);
  for (const double half_angle_deg : {180.0, 90.0, 30.0, 5.0, 1.0}) {
    for (const double radius : {0.5, 12.7, 1e3, 1e6}) {
      for (const double distance : {0.0, 1e3, 1e6}) {
        for (const int count : {4, 5, 25, 300}) {
          const Eigen::Vector3d center = distance * random_direction(random);
          const auto points = cap(center, radius, random_direction(random),
                                  half_angle_deg * std::numbers::pi / 180.0, count, random);
          const double u = testing::rounding_of(points);
          const SphereFit fit = fit_sphere(points, {.u_point_mm = u});
          if (fit.status == FitStatus::points_are_coplanar ||
              fit.status == FitStatus::radius_unbounded) {
            // Right only where rounding is as large as the height of the cap.
            const double height =
                radius * (1.0 - std::cos(half_angle_deg * std::numbers::pi / 180));
            EXPECT_LT(height, 400 * u) << half_angle_deg << " " << radius << " " << distance;
            continue;
          }
          ASSERT_TRUE(fit.ok()) << to_string(fit.status) << " cap " << half_angle_deg << " radius "
                                << radius << " distance " << distance << " points " << count;
          EXPECT_NEAR(fit.radius_mm, radius,
                      6.0 * *fit.standard_uncertainty("radius") + 4e-16 * radius)
              << half_angle_deg << " " << radius << " " << distance << " " << count;
          const double u_center = std::sqrt(fit.covariance->topLeftCorner<3, 3>().trace());
          EXPECT_LT((fit.center_mm - center).norm(), 6.0 * u_center + 4e-16 * (radius + distance))
              << half_angle_deg << " " << radius << " " << distance << " " << count;
        }
      }
    }
  }
}

TEST(SphereFit, CovarianceIsWhatSimulationShows) {
  RandomStream random(3);
  const double sigma = 0.002;
  const auto points = cap({100, 200, 300}, 12.7, Eigen::Vector3d::UnitZ(), 1.2, 25, random);
  const int trials = 1500;
  double distance = 0.0;
  double from_scatter = 0.0;
  for (int t = 0; t < trials; ++t) {
    const auto noisy = testing::with_noise(points, sigma, random);
    const SphereFit fit = fit_sphere(noisy, {.u_point_mm = sigma});
    ASSERT_TRUE(fit.ok());
    Eigen::Vector4d error;
    error << fit.center_mm - Eigen::Vector3d(100, 200, 300), fit.radius_mm - 12.7;
    distance += error.dot(shortest_solution(*fit.covariance, error)) / trials;
    from_scatter += fit_sphere(noisy).covariance->trace() / fit.covariance->trace() / trials;
  }
  // Chi-squared with 4 degrees of freedom: mean 4, variance 8; four standard errors of the mean.
  EXPECT_NEAR(distance, 4.0, 4.0 * std::sqrt(8.0 / trials));
  EXPECT_NEAR(from_scatter, 1.0, 0.05);
}

TEST(SphereFit, ReportsFormAndRms) {
  // Six points on the axes, two of them 0.3 mm out: by symmetry the centre stays.
  const std::vector<Eigen::Vector3d> points = {{10, 0, 0},  {-10, 0, 0},  {0, 10, 0},
                                               {0, -10, 0}, {0, 0, 10.3}, {0, 0, -10.3}};
  const SphereFit fit = fit_sphere(points);
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR(fit.center_mm.norm(), 0.0, 1e-14);
  EXPECT_NEAR(fit.radius_mm, 10.1, 1e-14);
  EXPECT_NEAR(fit.form_mm, 0.3, 1e-14);
  EXPECT_NEAR(fit.rms_mm, std::sqrt((4 * 0.01 + 2 * 0.04) / 6), 1e-14);
  EXPECT_EQ(fit.degrees_of_freedom, 2);
}

TEST(SphereFit, RefusesWithAReason) {
  using V = std::vector<Eigen::Vector3d>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fit_sphere(V{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).status, FitStatus::too_few_points);
  EXPECT_EQ(fit_sphere(V{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {3, 2, 5}, {1, 1, 5}}).status,
            FitStatus::points_are_coplanar);
  EXPECT_EQ(fit_sphere(V{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).status,
            FitStatus::points_are_collinear);
  EXPECT_EQ(fit_sphere(V(6, Eigen::Vector3d(1, 2, 3))).status, FitStatus::points_coincide);
  EXPECT_EQ(fit_sphere(V{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, nan}}).status,
            FitStatus::not_finite);
}

TEST(SphereFit, RefusesPointsThatAreCoplanarWithinTheirScatter) {
  // A ring and a grid in tilted planes, typed with four decimals: coplanar, but not to rounding.
  RandomStream random(11);
  for (int arm = 0; arm < 20; ++arm) {
    const auto [u, v] = perpendicular_pair(random_direction(random));
    std::vector<Eigen::Vector3d> ring;
    std::vector<Eigen::Vector3d> grid;
    for (int i = 0; i < 16; ++i) {
      const double angle = i * 2.0 * std::numbers::pi / 16;
      const auto typed = [](const Eigen::Vector3d& p) {
        return Eigen::Vector3d((p * 1e4).array().round() / 1e4);
      };
      ring.push_back(typed(12.7 * (std::cos(angle) * u + std::sin(angle) * v)));
      grid.push_back(typed((i % 4) * 5.0 * u + (i / 4) * 5.0 * v));
    }
    EXPECT_EQ(fit_sphere(ring).status, FitStatus::radius_unbounded) << arm;
    const SphereFit fit = fit_sphere(grid);
    // Sixteen points may by chance bow by twice their scatter; then the radius is thousands of
    // times the grid.
    EXPECT_TRUE(fit.status == FitStatus::radius_unbounded || fit.radius_mm > 1e4) << arm;
  }
}

}  // namespace
}  // namespace armcal
