// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/articulated_location_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/units.h"
#include "armcal/planning/verification/artefact_places.h"
#include "armcal/planning/verification/articulations.h"

namespace armcal {
namespace {

constexpr int kArticulationStarts = 300;
constexpr std::size_t kPlacesToCompare = 5;
constexpr std::size_t kArticulationsOfLocation = 5;
// More than five, so that there is a choice.
constexpr std::size_t kEnough = 4 * kArticulationsOfLocation;

std::string cover(const std::vector<Articulation>& chosen) {
  long left = 0;
  double least_turn = -1.0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    left += chosen[i].elbow_mm > 0.0 ? 1 : 0;
    for (std::size_t k = 0; k < i; ++k) {
      least_turn = std::max(least_turn, chosen[i].stylus.dot(chosen[k].stylus));
    }
  }
  return fmt::format("elbow left in {}, right in {}; styluses at least {:.0f} deg apart", left,
                     std::ssize(chosen) - left,
                     degrees_from_radians(std::acos(std::clamp(least_turn, -1.0, 1.0))));
}

struct SphereWithArticulations {
  PlannedSphere sphere;
  std::vector<Articulation> articulations;
};

// Of some places in the middle of the volume that are probed in enough articulations, the one where
// those chosen differ most.
SphereWithArticulations middle_sphere(const PlanningCircumstances& with, RandomStream& random) {
  const Shell shell{0.35 * with.reach_mm, 0.6 * with.reach_mm};
  TriedPlaces tried;
  const auto places = sphere_places(with.search, shell, with.sphere_at(Eigen::Vector3d::Zero()),
                                    pattern_of_5, kPlacesToCompare, random, tried);
  std::optional<SphereWithArticulations> best;
  std::size_t most = 0;
  for (const PlannedSphere& sphere : places) {
    auto found = articulations_at(with.search, with.sphere_at(sphere.centre_mm), sphere.pole,
                                  kArticulationStarts, random);
    most = std::max(most, found.size());
    if (found.size() < kEnough) continue;
    auto chosen = choose_articulations(std::move(found), kArticulationsOfLocation);
    if (best && least_distance_rad(chosen) <= least_distance_rad(best->articulations)) continue;
    best = {sphere, std::move(chosen)};
  }
  if (best) return *best;
  throw ImpossiblePlan(fmt::format(
      "articulated_location: no place for the sphere, {:.0f} to {:.0f} mm from the origin of joint "
      "1: {}; where it was reached, at most {} articulations were found, {} are needed to choose "
      "from",
      shell.inner_mm, shell.outer_mm, tried.text(), most, kEnough));
}

}  // namespace

PlannedTest plan_articulated_location(const PlanningCircumstances& with) {
  RandomStream random(with.wishes.seed, 2);
  PlannedTest test;
  test.name = "articulated_location";
  test.title = "ISO 10360-12 articulated location";
  test.is_of_iso = true;
  const Tip& tip = with.search.arm().tip;
  if (std::hypot(tip.a_mm, tip.b_mm, tip.d_mm) == 0.0) {
    throw ImpossiblePlan(
        "articulated_location: the tip lies at the origin of the last joint: there is no stylus "
        "that points anywhere");
  }
  auto [sphere, articulations] = middle_sphere(with, random);
  sphere.position = "middle";
  test.spheres = {sphere};
  int number = 0;
  for (const Articulation& articulation : articulations) {
    ++number;
    for (std::size_t i = 0; i < articulation.touches.size(); ++i) {
      PlannedTouch row;
      row.articulation = number;
      row.point = static_cast<int>(i) + 1;
      row.touch = articulation.touches[i];
      row.encoder_rad = articulation.postures_rad[i];
      test.touches.push_back(std::move(row));
    }
  }
  test.covers = cover(articulations);
  return test;
}

}  // namespace armcal
