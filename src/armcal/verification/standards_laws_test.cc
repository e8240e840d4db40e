// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "armcal/testing/points_on_sphere.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/verification/b89_4_22/single_point_articulation.h"
#include "armcal/verification/iso10360_12/articulated_location.h"
#include "armcal/verification/iso10360_12/probing_form.h"
#include "armcal/verification/iso10360_12/probing_size.h"

// What must hold for any readings.
namespace armcal {
namespace {

constexpr ReferenceSphere kBall{25.0, 6.0};

// Sets of noisy points on spheres whose centres scatter as well.
std::vector<SpherePoints> noisy_sets(int sets, int points, RandomStream& random) {
  std::vector<SpherePoints> found;
  for (int i = 0; i < sets; ++i) {
    const Eigen::Vector3d center =
        Eigen::Vector3d(300, 200, 100) + testing::random_normal_vector(random, 0.05);
    found.push_back(
        {std::to_string(i + 1),
         testing::with_noise(testing::points_on_sphere(center, 31.0, points), 0.03, random), ""});
  }
  return found;
}

std::vector<SpherePoints> moved(std::vector<SpherePoints> sets, const RigidTransform& motion) {
  for (SpherePoints& set : sets) {
    for (Eigen::Vector3d& point : set.points_mm) point = motion * point;
  }
  return sets;
}

std::vector<SpherePoints> reversed(std::vector<SpherePoints> sets) {
  for (SpherePoints& set : sets) std::reverse(set.points_mm.begin(), set.points_mm.end());
  std::reverse(sets.begin(), sets.end());
  return sets;
}

template <class Test>
void expect_invariant(Test test, const std::vector<SpherePoints>& sets, RandomStream& random) {
  const double value = test(sets, kBall).value_mm.value();
  const RigidTransform motion = testing::random_transform(random, 1000.0);
  // 1e-9 mm: rounding of coordinates of metres, in fits that magnify it by less than a hundred.
  RC_ASSERT(std::abs(test(moved(sets, motion), kBall).value_mm.value() - value) < 1e-9);
  RC_ASSERT(std::abs(test(reversed(sets), kBall).value_mm.value() - value) < 1e-9);
}

RC_GTEST_PROP(StandardsLaws, NeitherFrameNorOrderMatters, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
  const auto positions = noisy_sets(2, 25, random);
  expect_invariant(iso10360_12::probing_size, positions, random);
  expect_invariant(iso10360_12::probing_form, positions, random);
  expect_invariant(iso10360_12::articulated_location, noisy_sets(5, 5, random), random);
}

RC_GTEST_PROP(StandardsLaws, ALargerProbeChangesTheSizeAndNothingElse, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
  const auto positions = noisy_sets(1, 25, random);
  const ReferenceSphere less{25.0, 5.9};
  const auto size = [&](const ReferenceSphere& sphere) {
    return iso10360_12::probing_size(positions, sphere).value_mm.value();
  };
  RC_ASSERT(std::abs(size(less) - size(kBall) - 0.1) < 1e-12);
  RC_ASSERT(iso10360_12::probing_form(positions, less).value_mm ==
            iso10360_12::probing_form(positions, kBall).value_mm);
}

RC_GTEST_PROP(StandardsLaws, ScatterInASeatIsThatOfSpaceAndGrowsWithIt, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), 0);
  const RigidTransform motion = testing::random_transform(random, 1000.0);
  std::vector<Eigen::Vector3d> seat;
  std::vector<Eigen::Vector3d> other;
  for (int i = 0; i < 10; ++i) {
    seat.push_back(testing::random_normal_vector(random, 0.05));
    other.push_back(motion * Eigen::Vector3d(3.0 * seat.back()));
  }
  const auto scatter = b89_4_22::scatter_in_seat(seat);
  const auto larger = b89_4_22::scatter_in_seat(other);
  RC_ASSERT(std::abs(larger.largest_mm - 3.0 * scatter.largest_mm) < 1e-11);
  RC_ASSERT(std::abs(larger.twice_s_mm - 3.0 * scatter.twice_s_mm) < 1e-11);
  // No single point is farther away than all together allow.
  RC_ASSERT(scatter.largest_mm <= 1.5 * scatter.twice_s_mm);
}

}  // namespace
}  // namespace armcal
