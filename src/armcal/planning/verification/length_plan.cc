// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/length_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/planning/verification/artefact_places.h"

namespace armcal {
namespace {

constexpr int kRepeatsOfLength = 3;
constexpr double kLongestShare = 0.66;  // of the reach, at least
// Places to choose from, so that bars lie apart.
constexpr std::size_t kLengthPlaces = 8;

struct Direction {
  const char* name;
  Eigen::Vector3d along;
};

std::vector<Direction> seven_directions() {
  return {{"along x", {1, 0, 0}},
          {"along y", {0, 1, 0}},
          {"along z", {0, 0, 1}},
          {"diagonal +x +y +z", {1, 1, 1}},
          {"diagonal -x +y +z", {-1, 1, 1}},
          {"diagonal +x -y +z", {1, -1, 1}},
          {"diagonal -x -y +z", {-1, -1, 1}}};
}

// Of the places for a bar, the one whose ends are farthest from those of the bars before.
const PlannedBar& most_apart(const std::vector<PlannedBar>& places,
                             const std::vector<PlannedBar>& before) {
  const auto distance = [&](const PlannedBar& bar) {
    double nearest = HUGE_VAL;
    for (const PlannedBar& each : before) {
      nearest =
          std::min({nearest, (bar.from_mm - each.from_mm).norm(), (bar.from_mm - each.to_mm).norm(),
                    (bar.to_mm - each.from_mm).norm(), (bar.to_mm - each.to_mm).norm()});
    }
    return nearest;
  };
  return *std::max_element(places.begin(), places.end(), [&](const auto& one, const auto& other) {
    return distance(one) < distance(other);
  });
}

void add_lengths(const TouchSearch& search, PlannedTest& test, const PlannedBar& bar,
                 RandomStream& random) {
  for (const double length : bar.lengths_mm) {
    for (int repeat = 1; repeat <= kRepeatsOfLength; ++repeat) {
      for (const char end : {'A', 'B'}) {
        PlannedTouch row;
        row.position = bar.position;
        row.length_mm = length;
        row.repeat = repeat;
        row.end = end;
        row.touch = seat_on(search, bar, end == 'A' ? 0.0 : length);
        add_touch(search, test, std::move(row), random);
      }
    }
  }
}

std::string lengths_cover(const PlanningCircumstances& with, const PlannedTest& test) {
  double least = HUGE_VAL;
  double most = 0.0;
  for (const PlannedTouch& row : test.touches) {
    least = std::min(least, with.share_of_reach(row.touch.tip_mm));
    most = std::max(most, with.share_of_reach(row.touch.tip_mm));
  }
  return fmt::format(
      "the three axes and four diagonals of the base frame; ends from {:.0f} to {:.0f} % of the "
      "reach; the longest length is {:.0f} % of it",
      100.0 * least, 100.0 * most, 100.0 * with.wishes.lengths_mm.back() / with.reach_mm);
}

}  // namespace

PlannedTest plan_length_uni(const PlanningCircumstances& with) {
  RandomStream random(with.wishes.seed, 3);
  PlannedTest test;
  test.name = "length_uni";
  test.title = "ISO 10360-12 unidirectional lengths";
  test.is_of_iso = true;
  std::string problems;
  for (const auto& [name, along] : seven_directions()) {
    TriedPlaces tried;
    const auto places = bar_places(with.search, along.normalized(), with.wishes.lengths_mm,
                                   kLengthPlaces, random, tried);
    if (places.empty()) {
      problems += fmt::format("{}length_uni: no place for a bar of {:.0f} mm {}: {}",
                              problems.empty() ? "" : "\n", with.wishes.lengths_mm.back(), name,
                              tried.text());
      continue;
    }
    test.bars.push_back(most_apart(places, test.bars));
    test.bars.back().position = name;
  }
  if (!problems.empty()) throw ImpossiblePlan(problems);
  for (const PlannedBar& bar : test.bars) add_lengths(with.search, test, bar, random);
  test.covers = lengths_cover(with, test);
  return test;
}

std::vector<double> usual_lengths(double reach_mm) {
  const double longest = kRoundLength_mm * std::ceil(kLongestShare * reach_mm / kRoundLength_mm);
  std::vector<double> lengths;
  for (int i = 1; i <= 5; ++i) lengths.push_back(longest * i / 5);
  return lengths;
}

}  // namespace armcal
