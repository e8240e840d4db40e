// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/single_point_plan.h"

#include <fmt/format.h>

#include "armcal/planning/verification/artefact_places.h"

namespace armcal {
namespace {

constexpr std::size_t kArticulationsOfSeat = 10;

// Seats stand well inside their zones, so that a reach that is stated a little differently leaves
// them there; shares of the reach.
struct Zone {
  const char* name;
  double inner;
  double outer;
};
constexpr Zone kZones[] = {{"near", 0.08, 0.18}, {"middle", 0.4, 0.6}, {"far", 0.82, 0.97}};

void add_articulations(PlannedTest& test, const SeatPlace& place) {
  int articulation = 0;
  for (const Eigen::VectorXd& posture : place.postures_rad) {
    PlannedTouch row;
    row.position = place.seat.zone;
    row.articulation = ++articulation;
    row.touch = {place.seat.at_mm, place.seat.axis};
    row.encoder_rad = posture;
    test.touches.push_back(std::move(row));
  }
}

}  // namespace

PlannedTest plan_single_point_articulation(const PlanningCircumstances& with) {
  RandomStream random(with.wishes.seed, 12);
  PlannedTest test;
  test.name = "single_point_articulation";
  test.title = "B89.4.22 single-point articulation";
  std::string problems;
  for (const Zone& zone : kZones) {
    const Shell shell{zone.inner * with.reach_mm, zone.outer * with.reach_mm};
    TriedPlaces tried;
    auto place = seat_place(with.search, shell, kArticulationsOfSeat, random, tried);
    if (!place) {
      problems += fmt::format(
          "{}single_point_articulation: no place for the {} seat, {:.0f} to {:.0f} mm from the "
          "origin of joint 1: {}",
          problems.empty() ? "" : "\n", zone.name, shell.inner_mm, shell.outer_mm, tried.text());
      continue;
    }
    place->seat.zone = zone.name;
    test.seats.push_back(place->seat);
    test.covers += fmt::format("{}{} {}", test.covers.empty() ? "" : ", ", zone.name,
                               distance_text(with, place->seat.at_mm));
    add_articulations(test, *place);
  }
  if (!problems.empty()) throw ImpossiblePlan(problems);
  return test;
}

}  // namespace armcal
