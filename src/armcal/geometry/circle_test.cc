// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/circle.h"

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

using std::numbers::pi;
using testing::random_direction;

std::vector<Eigen::Vector3d> arc(const Eigen::Vector3d& center, double radius,
                                 const Eigen::Vector3d& normal, double sweep_rad, int count,
                                 RandomStream& random) {
  using Long = long double;
  const auto [u, v] = perpendicular_pair(normal);
  const double start = random.uniform(0, 2 * pi);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Long angle = start + static_cast<Long>(sweep_rad) * i / count;
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) {
      point(k) = static_cast<double>(static_cast<Long>(center(k)) +
                                     radius * (std::cos(angle) * static_cast<Long>(u(k)) +
                                               std::sin(angle) * static_cast<Long>(v(k))));
    }
    points.push_back(point);
  }
  return points;
}

// Published planar circles: Gander, Golub, Strebel 1994; SciPy Cookbook. Answers refined to more
// digits than printed; that of scipy_cookbook_full is ours to 1e-13 (the gradient vanishes there to
// 1e-15 in extended precision; the reference data differ by 6e-12 in y, where it is 2e-11).
struct PublishedCircle {
  const char* name;
  std::vector<Eigen::Vector2d> points;
  Eigen::Vector2d center;
  double radius;
  double sum_of_squares;
};

const std::vector<PublishedCircle>& published_circles() {
  static const std::vector<PublishedCircle> circles = {
      {"gander1994",
       {{1, 7}, {2, 6}, {5, 8}, {7, 7}, {9, 5}, {3, 7}},
       {4.73978241090607403, 2.98353269929247516},
       4.71422603779210975,
       1.22759907818365635},
      {"scipy_cookbook_full",
       {{9, 34}, {35, 10}, {-13, 6}, {10, -14}, {23, 27}, {0, -10}},
       {10.5000862139443770, 9.65994950583642981},
       23.3335276461828767,
       7.71185223881996280},
      {"scipy_cookbook_arc",
       {{36, 14}, {36, 10}, {19, 28}, {18, 31}, {33, 18}, {26, 26}},
       {9.88756656747738749, 3.68749730978412046},
       27.3504431681337441,
       4.04252189831859094}};
  return circles;
}

TEST(PlanarCircleFit, AgreesWithPublishedAnswers) {
  for (const PublishedCircle& circle : published_circles()) {
    const CircleFit fit = fit_circle(circle.points);
    ASSERT_TRUE(fit.ok()) << circle.name << " " << to_string(fit.status);
    EXPECT_NEAR(fit.center_mm.x(), circle.center.x(), 1e-12) << circle.name;
    EXPECT_NEAR(fit.center_mm.y(), circle.center.y(), 1e-12) << circle.name;
    EXPECT_NEAR(fit.radius_mm, circle.radius, 1e-12) << circle.name;
    EXPECT_NEAR(fit.rms_mm * fit.rms_mm * 6, circle.sum_of_squares, 1e-13) << circle.name;
    EXPECT_EQ(fit.normal, Eigen::Vector3d::UnitZ());
  }
}

TEST(PlanarCircleFit, TheSameCircleInSpaceHasTheSameAnswer) {
  RandomStream random(5);
  for (const PublishedCircle& circle : published_circles()) {
    const RigidTransform space_from_plane = testing::random_transform(random, 100.0);
    std::vector<Eigen::Vector3d> points;
    for (const auto& p : circle.points) {
      points.push_back(space_from_plane * Eigen::Vector3d(p.x(), p.y(), 0));
    }
    for (const CircleMethod method : {CircleMethod::orthogonal, CircleMethod::plane_first}) {
      const CircleFit fit = fit_circle(points, {{}, method});
      ASSERT_TRUE(fit.ok()) << circle.name;
      EXPECT_NEAR(fit.radius_mm, circle.radius, 1e-11) << circle.name;
      const Eigen::Vector3d center =
          space_from_plane * Eigen::Vector3d(circle.center.x(), circle.center.y(), 0);
      EXPECT_NEAR((fit.center_mm - center).norm(), 0, 1e-11) << circle.name;
    }
  }
}

TEST(CircleFit, PlaneFirstAgreesWithNist) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  const auto pairs = testing::nist_pairs("Circle3d");
  ASSERT_EQ(pairs.size(), 6u);
  for (const auto& pair : pairs) {
    const CircleFit fit = fit_circle(pair.points, {{}, CircleMethod::plane_first});
    ASSERT_TRUE(fit.ok()) << pair.name;
    const Eigen::Vector3d center(pair.fit[0], pair.fit[1], pair.fit[2]);
    const Eigen::Vector3d normal(pair.fit[3], pair.fit[4], pair.fit[5]);
    EXPECT_LT((fit.center_mm - center).norm(), 1e-9) << pair.name;
    EXPECT_LT(fit.normal.cross(normal).norm(), 1e-11) << pair.name;
    EXPECT_NEAR(2.0 * fit.radius_mm, pair.fit[6], 1e-9) << pair.name;
  }
}

TEST(CircleFit, OrthogonalNeverFitsWorseThanPlaneFirst) {
  ARMCAL_NEEDS_REFERENCE_DATA();
  for (const auto& pair : testing::nist_pairs("Circle3d")) {
    const double plane_first = fit_circle(pair.points, {{}, CircleMethod::plane_first}).rms_mm;
    const double orthogonal = fit_circle(pair.points).rms_mm;
    EXPECT_LE(orthogonal, plane_first * (1 + 1e-12) + 1e-14) << pair.name;
  }
}

TEST(CircleFit, OrthogonalIsAMinimum) {
  // No neighbour of the fitted circle has a smaller sum of squares, on data so rough that
  // plane-first differs.
  RandomStream random(6);
  auto points = arc({1, 2, 3}, 10, random_direction(random), 4.0, 15, random);
  points = testing::with_noise(points, 0.8, random);
  const CircleFit fit = fit_circle(points);
  ASSERT_TRUE(fit.ok());
  const auto sum_of_squares = [&](const Eigen::Vector3d& c, const Eigen::Vector3d& n, double r) {
    double sum = 0;
    for (const auto& p : points) {
      const double height = n.dot(p - c);
      const double radial = (p - c - height * n).norm() - r;
      sum += height * height + radial * radial;
    }
    return sum;
  };
  const double best = sum_of_squares(fit.center_mm, fit.normal, fit.radius_mm);
  EXPECT_NEAR(best, fit.residuals_mm.squaredNorm(), 1e-12);
  const double plane_first =
      fit_circle(points, {{}, CircleMethod::plane_first}).residuals_mm.squaredNorm();
  EXPECT_LT(best, plane_first - 1e-4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d c = fit.center_mm + testing::random_normal_vector(random, 1e-4);
    const Eigen::Vector3d n =
        (fit.normal + testing::random_normal_vector(random, 1e-5)).normalized();
    EXPECT_GE(sum_of_squares(c, n, fit.radius_mm + 1e-4 * random.normal()), best);
  }
}

TEST(CircleFit, ReachesWhatTheDataAllow) {
  RandomStream random(8);
  for (const double sweep_deg : {360.0, 90.0, 10.0, 1.0}) {
    for (const double radius : {0.5, 178.383, 1e6}) {
      for (const double distance : {0.0, 1e3, 1e6}) {
        for (const int count : {3, 4, 50}) {
          const Eigen::Vector3d center = distance * random_direction(random);
          const Eigen::Vector3d normal = random_direction(random);
          const auto points = arc(center, radius, normal, sweep_deg * pi / 180, count, random);
          const double u = testing::rounding_of(points);
          for (const CircleMethod method : {CircleMethod::orthogonal, CircleMethod::plane_first}) {
            const CircleFit fit = fit_circle(points, {{u}, method});
            const auto where = [&] {
              return ::testing::Message()
                     << "sweep " << sweep_deg << " radius " << radius << " distance " << distance
                     << " count " << count << " " << to_string(fit.status);
            };
            if (fit.status == FitStatus::points_are_collinear ||
                fit.status == FitStatus::radius_unbounded) {
              const double sagitta = radius * (1 - std::cos(sweep_deg * pi / 360));
              EXPECT_LT(sagitta, 400 * u) << where();
              continue;
            }
            ASSERT_TRUE(fit.ok()) << where();
            EXPECT_NEAR(fit.radius_mm, radius,
                        6.0 * *fit.standard_uncertainty("radius") + 4e-16 * radius)
                << where();
            const double u_normal = std::sqrt(fit.covariance->block<3, 3>(3, 3).trace());
            EXPECT_LT(fit.normal.cross(normal).norm(), 6.0 * u_normal + 1e-15) << where();
          }
        }
      }
    }
  }
}

TEST(CircleFit, CovarianceIsWhatSimulationShows) {
  RandomStream random(9);
  const double sigma = 0.002;
  const Eigen::Vector3d normal = random_direction(random);
  const Eigen::Vector3d center(100, -50, 20);
  const auto points = arc(center, 25, normal, 2.5, 20, random);
  const int trials = 1500;
  for (const CircleMethod method : {CircleMethod::orthogonal, CircleMethod::plane_first}) {
    double distance = 0.0;
    for (int t = 0; t < trials; ++t) {
      const auto noisy = testing::with_noise(points, sigma, random);
      const CircleFit fit = fit_circle(noisy, {{sigma}, method});
      const Eigen::Vector3d turned = fit.normal.dot(normal) < 0 ? -fit.normal : fit.normal;
      Eigen::VectorXd error(7);
      error << fit.center_mm - center, turned - normal, fit.radius_mm - 25;
      // Six unknowns in seven numbers: the covariance has rank 6, its shortest inverse does the
      // rest.
      distance += error.dot(shortest_solution(*fit.covariance, error)) / trials;
    }
    EXPECT_NEAR(distance, 6.0, 4.0 * std::sqrt(12.0 / trials));
  }
}

TEST(CircleFit, RefusesWithAReason) {
  using V = std::vector<Eigen::Vector3d>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fit_circle(V{{0, 0, 0}, {1, 0, 0}}).status, FitStatus::too_few_points);
  EXPECT_EQ(fit_circle(V{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}).status,
            FitStatus::points_are_collinear);
  EXPECT_EQ(fit_circle(V(5, Eigen::Vector3d(1, 2, 3))).status, FitStatus::points_coincide);
  EXPECT_EQ(fit_circle(V{{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}}).status, FitStatus::not_finite);
}

TEST(PlanarCircleFit, RefusesARadiusThatRunsToInfinity) {
  using V = std::vector<Eigen::Vector2d>;
  // A zigzag about a straight line: no circle fits better than the line.
  EXPECT_EQ(fit_circle(V{{0, .1}, {1, -.1}, {2, .1}, {3, -.1}, {4, .1}, {5, -.1}}).status,
            FitStatus::radius_unbounded);
  EXPECT_EQ(fit_circle(V{{0, 0}, {1, 0}, {2, 0}}).status, FitStatus::points_are_collinear);
}

}  // namespace
}  // namespace armcal
