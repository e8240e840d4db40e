// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/probing_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/units.h"
#include "armcal/planning/verification/artefact_places.h"

namespace armcal {
namespace {

// Places to choose from, so that the spheres stand in different directions.
constexpr std::size_t kSpherePlaces = 8;

double angle_at_origin(const TouchSearch& search, const Eigen::Vector3d& one,
                       const Eigen::Vector3d& other) {
  const Eigen::Vector3d a = (one - search.origin_mm()).normalized();
  const Eigen::Vector3d b = (other - search.origin_mm()).normalized();
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

// The sphere near the base and the one far from it.
std::vector<PlannedSphere> near_and_far(const PlanningCircumstances& with, RandomStream& random) {
  const auto places = [&](const char* position, double inner, double outer, std::size_t most) {
    const Shell shell{inner * with.reach_mm, outer * with.reach_mm};
    TriedPlaces tried;
    auto found = sphere_places(with.search, shell, with.sphere_at(Eigen::Vector3d::Zero()),
                               pattern_of_25, most, random, tried);
    if (found.empty()) {
      throw ImpossiblePlan(fmt::format(
          "probing: no place for the {} sphere, {:.0f} to {:.0f} mm from the origin of joint 1: {}",
          position, shell.inner_mm, shell.outer_mm, tried.text()));
    }
    for (PlannedSphere& sphere : found) sphere.position = position;
    return found;
  };
  const PlannedSphere near = places("near", 0.2, 0.45, 1).front();
  const auto far = places("far", 0.65, 0.9, kSpherePlaces);
  const auto angle = [&](const PlannedSphere& sphere) {
    return angle_at_origin(with.search, near.centre_mm, sphere.centre_mm);
  };
  return {near, *std::max_element(far.begin(), far.end(), [&](const auto& one, const auto& other) {
            return angle(one) < angle(other);
          })};
}

}  // namespace

PlannedTest plan_probing(const PlanningCircumstances& with) {
  RandomStream random(with.wishes.seed, 1);
  PlannedTest test;
  test.name = "probing";
  test.title = "ISO 10360-12 probing size and form";
  test.is_of_iso = true;
  test.spheres = near_and_far(with, random);
  for (const PlannedSphere& sphere : test.spheres) {
    int point = 0;
    for (const Eigen::Vector3d& direction : pattern_of_25(sphere.pole)) {
      PlannedTouch row;
      row.position = sphere.position;
      row.point = ++point;
      row.touch = with.sphere_at(sphere.centre_mm).touch(direction);
      add_touch(with.search, test, std::move(row), random);
    }
  }
  const Eigen::Vector3d& near = test.spheres[0].centre_mm;
  const Eigen::Vector3d& far = test.spheres[1].centre_mm;
  test.covers = fmt::format("near {}, far {}, {:.0f} deg apart as seen from joint 1",
                            distance_text(with, near), distance_text(with, far),
                            degrees_from_radians(angle_at_origin(with.search, near, far)));
  return test;
}

}  // namespace armcal
