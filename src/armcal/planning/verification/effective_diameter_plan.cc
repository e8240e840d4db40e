// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/effective_diameter_plan.h"

#include <fmt/format.h>

#include "armcal/planning/verification/artefact_places.h"

namespace armcal {
namespace {

constexpr int kFits = 3;

}  // namespace

PlannedTest plan_effective_diameter(const PlanningCircumstances& with) {
  RandomStream random(with.wishes.seed, 11);
  PlannedTest test;
  test.name = "effective_diameter";
  test.title = "B89.4.22 effective diameter";
  const Shell shell{0.4 * with.reach_mm, 0.7 * with.reach_mm};
  TriedPlaces tried;
  test.spheres = sphere_places(with.search, shell, with.sphere_at(Eigen::Vector3d::Zero()),
                               pattern_of_9, 1, random, tried);
  if (test.spheres.empty()) {
    throw ImpossiblePlan(fmt::format(
        "effective_diameter: no place for the sphere, {:.0f} to {:.0f} mm from the origin of joint "
        "1: {}",
        shell.inner_mm, shell.outer_mm, tried.text()));
  }
  PlannedSphere& sphere = test.spheres.front();
  sphere.position = "middle";
  for (int repeat = 1; repeat <= kFits; ++repeat) {
    int point = 0;
    for (const Eigen::Vector3d& direction : pattern_of_9(sphere.pole)) {
      PlannedTouch row;
      row.repeat = repeat;
      row.point = ++point;
      row.touch = with.sphere_at(sphere.centre_mm).touch(direction);
      add_touch(with.search, test, std::move(row), random);
    }
  }
  test.covers = distance_text(with, sphere.centre_mm);
  return test;
}

}  // namespace armcal
