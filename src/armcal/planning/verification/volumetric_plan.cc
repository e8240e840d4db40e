// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/volumetric_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "armcal/core/units.h"
#include "armcal/planning/verification/artefact_places.h"

namespace armcal {
namespace {

constexpr int kPlacementsOfEach = 10;
constexpr std::size_t kBarPlaces = 40;

Eigen::Vector3d middle_of(const PlannedBar& bar) { return 0.5 * (bar.from_mm + bar.to_mm); }

// Bars a reach apart differ as much as bars at right angles.
double difference(const PlannedBar& one, const PlannedBar& other, double reach_mm) {
  const double apart = (middle_of(one) - middle_of(other)).norm() / reach_mm;
  const Eigen::Vector3d along = (one.to_mm - one.from_mm).normalized();
  const Eigen::Vector3d other_along = (other.to_mm - other.from_mm).normalized();
  const double turn = std::acos(std::min(1.0, std::abs(along.dot(other_along))));
  return std::hypot(apart, turn / (0.5 * std::numbers::pi));
}

std::vector<PlannedBar> places_for(const PlanningCircumstances& with, double length_mm,
                                   RandomStream& random, std::string& problems) {
  TriedPlaces tried;
  auto places =
      bar_places(with.search, Eigen::Vector3d::Zero(), {length_mm}, kBarPlaces, random, tried);
  if (places.size() < kPlacementsOfEach) {
    problems += fmt::format(
        "{}volumetric_length: only {} places, not {}, for a bar of {:.0f} mm: {}",
        problems.empty() ? "" : "\n", places.size(), kPlacementsOfEach, length_mm, tried.text());
  }
  return places;
}

// Takes the place that differs most from the bars chosen before out of those that are left.
PlannedBar take_most_different(std::vector<PlannedBar>& places,
                               const std::vector<PlannedBar>& chosen, double reach_mm) {
  std::size_t best = 0;
  double farthest = -1.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double nearest = HUGE_VAL;
    for (const PlannedBar& each : chosen) {
      nearest = std::min(nearest, difference(places[i], each, reach_mm));
    }
    if (nearest <= farthest) continue;
    farthest = nearest;
    best = i;
  }
  PlannedBar taken = places[best];
  places.erase(places.begin() + static_cast<std::ptrdiff_t>(best));
  return taken;
}

std::string cover(const TouchSearch& search, const std::vector<PlannedBar>& bars) {
  std::set<int> octants;
  double least_steep = 90.0;
  double steepest = 0.0;
  const Eigen::Matrix3d axes = search.arm().base_from_first_joint.rotation;
  for (const PlannedBar& bar : bars) {
    const Eigen::Vector3d seen =
        axes.transpose() * (middle_of(bar) - search.outermost_reach().centre_mm);
    octants.insert((seen.x() > 0.0 ? 1 : 0) + (seen.y() > 0.0 ? 2 : 0) + (seen.z() > 0.0 ? 4 : 0));
    const double sine = std::abs(search.up().dot((bar.to_mm - bar.from_mm).normalized()));
    const double slope = degrees_from_radians(std::asin(std::min(1.0, sine)));
    least_steep = std::min(least_steep, slope);
    steepest = std::max(steepest, slope);
  }
  return fmt::format(
      "middles in {} of the 8 octants about joint 2; bars rise by {:.0f} to {:.0f} deg",
      octants.size(), least_steep, steepest);
}

void add_placement(const PlanningCircumstances& with, PlannedTest& test, PlannedBar bar,
                   RandomStream& random) {
  const int placement = static_cast<int>(test.bars.size()) + 1;
  bar.position = fmt::format("{}", placement);
  for (const char end : {'A', 'B'}) {
    PlannedTouch row;
    row.placement = placement;
    row.length_mm = bar.lengths_mm.back();
    row.end = end;
    row.touch = seat_on(with.search, bar, end == 'A' ? 0.0 : row.length_mm);
    add_touch(with.search, test, std::move(row), random);
  }
  test.bars.push_back(std::move(bar));
}

}  // namespace

PlannedTest plan_volumetric_length(const PlanningCircumstances& with) {
  RandomStream random(with.wishes.seed, 13);
  PlannedTest test;
  test.name = "volumetric_length";
  test.title = "B89.4.22 volumetric length";
  std::string problems;
  auto short_places = places_for(with, with.wishes.bars_mm[0], random, problems);
  auto long_places = places_for(with, with.wishes.bars_mm[1], random, problems);
  if (!problems.empty()) throw ImpossiblePlan(problems);
  for (int i = 0; i < kPlacementsOfEach; ++i) {
    for (auto* places : {&short_places, &long_places}) {
      add_placement(with, test, take_most_different(*places, test.bars, with.reach_mm), random);
    }
  }
  test.covers = cover(with.search, test.bars);
  return test;
}

std::array<double, 2> usual_bars(double reach_mm) {
  const auto rounded = [&](double share) {
    return kRoundLength_mm * std::round(share * reach_mm / kRoundLength_mm);
  };
  return {rounded(0.6), rounded(1.2)};
}

}  // namespace armcal
