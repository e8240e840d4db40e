// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/registration.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/testing/random_geometry.h"

namespace armcal {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points cloud(int count, double size_mm, RandomStream& random) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(testing::random_normal_vector(random, size_mm));
  return points;
}

Points moved(const RigidTransform& transform, double scale, const Points& points) {
  Points result;
  for (const auto& p : points) result.push_back(transform * Eigen::Vector3d(scale * p));
  return result;
}

TEST(Registration, RecoversAnyMovement) {
  RandomStream random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const RigidTransform truth = testing::random_transform(random, 1000.0);
    const int count = 3 + static_cast<int>(random.below(10));
    const Points source = cloud(count, 200.0, random);
    const Registration fit = register_points(source, moved(truth, 1.0, source));
    ASSERT_TRUE(fit.ok());
    EXPECT_NEAR((fit.target_from_source.rotation - truth.rotation).norm(), 0, 1e-13);
    EXPECT_NEAR((fit.target_from_source.translation_mm - truth.translation_mm).norm(), 0, 2e-11);
    EXPECT_LT(fit.rms_mm, 1e-11);
    EXPECT_FALSE(fit.looks_mirrored);
    EXPECT_EQ(fit.scale, 1.0);
  }
}

TEST(Registration, RecoversScaleOnlyWhenAsked) {
  RandomStream random(2);
  const RigidTransform truth = testing::random_transform(random, 500.0);
  const Points source = cloud(6, 100.0, random);
  const Points target = moved(truth, 1.0005, source);
  const Registration with = register_points(source, target, {{}, true});
  ASSERT_TRUE(with.ok());
  EXPECT_NEAR(with.scale, 1.0005, 1e-14);
  EXPECT_LT(with.rms_mm, 1e-11);
  EXPECT_GT(register_points(source, target).rms_mm, 0.01);
}

TEST(Registration, NeverReturnsAReflection) {
  RandomStream random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Points source = cloud(8, 100.0, random);
    Points mirrored = source;
    for (auto& p : mirrored) p.z() = -p.z();
    const Registration fit = register_points(source, mirrored);
    EXPECT_TRUE(fit.looks_mirrored);
    if (!fit.ok()) continue;
    EXPECT_NEAR(fit.target_from_source.rotation.determinant(), 1.0, 1e-12);
    EXPECT_GT(fit.rms_mm, 1.0);
  }
}

TEST(Registration, CoplanarPointsAreEnough) {
  RandomStream random(4);
  Points source = cloud(5, 100.0, random);
  for (auto& p : source) p.z() = 0.0;
  const RigidTransform truth = testing::random_transform(random, 100.0);
  const Registration fit = register_points(source, moved(truth, 1.0, source));
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR((fit.target_from_source.rotation - truth.rotation).norm(), 0, 1e-13);
}

// Source points far from their origin and a long translation: what a turn does to either shows.
struct FarScene {
  RandomStream random{5};
  double sigma_mm = 0.01;
  Points source =
      moved({Eigen::Matrix3d::Identity(), {900.0, -400.0, 250.0}}, 1.0, cloud(7, 50.0, random));
  RigidTransform truth = testing::random_transform(random, 2000.0);
  Points target = moved(truth, 1.001, source);

  Registration fit_noisy() {
    return register_points(source, testing::with_noise(target, sigma_mm, random),
                           {{sigma_mm}, true});
  }
  // turn, translation, scale: as covariance_of defines them
  [[nodiscard]] Eigen::VectorXd error_of(const Registration& fit) const {
    Eigen::VectorXd error(7);
    error << vector_from_rotation(fit.target_from_source.rotation * truth.rotation.transpose()),
        fit.target_from_source.translation_mm - truth.translation_mm, fit.scale - 1.001;
    return error;
  }
};

TEST(Registration, CovarianceIsWhatSimulationShows) {
  FarScene scene;
  const int trials = 1500;
  double distance = 0.0;
  for (int t = 0; t < trials; ++t) {
    const Registration fit = scene.fit_noisy();
    const Eigen::VectorXd error = scene.error_of(fit);
    distance += error.dot(shortest_solution(*fit.covariance, error)) / trials;
  }
  EXPECT_NEAR(distance, 7.0, 4.0 * std::sqrt(14.0 / trials));
}

// u of the translation once belonged to a turn about the target's origin, and not to the numbers
// that it stood beside.
TEST(Registration, UncertaintyIsTheScatterOfThePrintedNumbers) {
  FarScene scene;
  const int trials = 3000;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(7);
  for (int t = 0; t < trials; ++t) {
    squares += scene.error_of(scene.fit_noisy()).cwiseAbs2() / trials;
  }
  const Registration fit = scene.fit_noisy();
  for (int k = 0; k < 7; ++k) {
    const double u = *fit.standard_uncertainty(fit.covariance_of[static_cast<std::size_t>(k)]);
    // A standard deviation from 3000 trials is known to 1.3 %.
    EXPECT_NEAR(std::sqrt(squares(k)) / u, 1.0, 0.05)
        << fit.covariance_of[static_cast<std::size_t>(k)];
  }
}

TEST(Registration, RefusesWithAReason) {
  const Points line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {4, 4, 4}};
  const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Points spot(4, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(register_points(line, line).status, FitStatus::points_are_collinear);
  EXPECT_EQ(register_points(square, line).status, FitStatus::points_are_collinear);
  EXPECT_EQ(register_points(square, spot).status, FitStatus::points_coincide);
  EXPECT_EQ(register_points(Points{{0, 0, 0}, {1, 0, 0}}, Points{{0, 0, 0}, {1, 0, 0}}).status,
            FitStatus::too_few_points);
  Points broken = square;
  broken[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(register_points(square, broken).status, FitStatus::not_finite);
  EXPECT_THROW(static_cast<void>(register_points(square, Points{{0, 0, 0}})),
               std::invalid_argument);
}

TEST(Registration, RefusesWhenTwoRotationsFitAlike) {
  // The regular tetrahedron against its mirror image: many rotations are equally wrong.
  const Points tetrahedron = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  Points mirrored = tetrahedron;
  for (auto& p : mirrored) p = -p;
  EXPECT_EQ(register_points(tetrahedron, mirrored).status, FitStatus::ambiguous);
}

TEST(NearestRotation, IsTheRotationItselfAndNeverAReflection) {
  RandomStream random(32);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Matrix3d rotation = rotation_from_vector(testing::random_normal_vector(random));
    EXPECT_LT((nearest_rotation(2.0 * rotation) - rotation).norm(), 1e-14);
    const Eigen::Matrix3d nearest = nearest_rotation(-rotation);
    EXPECT_NEAR(nearest.determinant(), 1.0, 1e-14);
    EXPECT_LT((nearest * nearest.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace armcal
