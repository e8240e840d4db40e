// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/artefact_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/simulation/placement.h"
#include "armcal/simulation/posture_choice.h"

namespace armcal {
namespace {

constexpr int kPlacesToTry = 3000;
// Of these, so many are looked at with the arm's joints, which takes a thousand times as long.
constexpr int kPlacesLookedAt = 150;
constexpr int kBarTries = 1000;
// Half the width of a bar, and what clamps and stems need.
constexpr double kClearance_mm = 30.0;
constexpr double kSteepestSine = 0.7071067811865476;  // of 45 deg above the level
// Of postures tried for a seat, for each one that is kept.
constexpr std::size_t kPosturesPerKept = 4;
constexpr int kStartsPerKept = 60;
// A bar nearer to upright than this (30 deg) has its seats open towards the first axis.
constexpr double kUprightCosine = 0.866;

Eigen::Vector3d random_direction(RandomStream& random) {
  const double height = random.uniform(-1.0, 1.0);
  const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double across = std::sqrt(1.0 - height * height);
  return {across * std::cos(turn), across * std::sin(turn), height};
}

Eigen::Vector3d random_point(const TouchSearch& search, const Shell& shell, RandomStream& random) {
  for (;;) {
    const Eigen::Vector3d direction = random_direction(random);
    if (std::abs(search.up().dot(direction)) > kSteepestSine) continue;
    return search.origin_mm() + random.uniform(shell.inner_mm, shell.outer_mm) * direction;
  }
}

// Ways in which a sphere's pole or a seat may look.
std::vector<Eigen::Vector3d> poles_at(const TouchSearch& search, const Eigen::Vector3d& point_mm) {
  const Eigen::Vector3d back = -search.level_direction(point_mm);
  return {search.up(), (search.up() + back).normalized(), back};
}

bool reaches_all(const TouchSearch& search, const SphereToProbe& sphere,
                 const std::vector<Eigen::Vector3d>& directions, RandomStream& random) {
  return std::all_of(directions.begin(), directions.end(), [&](const Eigen::Vector3d& direction) {
    const Touch touch = sphere.touch(direction);
    return !search.fault_at(touch.tip_mm) && search.reaches(touch, random);
  });
}

// Why a bar cannot lie there, as far as it is known without a look at the joints.
std::optional<std::string> fault_of(const TouchSearch& search, const PlannedBar& bar) {
  // Most places fail at an end.
  for (const Eigen::Vector3d& end : {bar.from_mm, bar.to_mm}) {
    if (auto fault = search.fault_at(end, kClearance_mm)) return fault;
  }
  for (const Eigen::Vector3d& point : bar_body(bar.from_mm, bar.to_mm)) {
    if (auto fault = search.fault_at(point, kClearance_mm)) return fault;
  }
  return std::nullopt;
}

bool reaches_ends(const TouchSearch& search, const PlannedBar& bar, RandomStream& random) {
  if (!search.reaches(seat_on(search, bar, 0.0), random)) return false;
  return std::all_of(bar.lengths_mm.begin(), bar.lengths_mm.end(), [&](double length) {
    return search.reaches(seat_on(search, bar, length), random);
  });
}

PlannedBar random_bar(const TouchSearch& search, Eigen::Vector3d direction,
                      const std::vector<double>& lengths_mm, RandomStream& random) {
  if (direction.isZero()) direction = random_direction(random);
  if (random.below(2) == 1) direction = -direction;
  const double length = lengths_mm.back();
  const auto [centre, radius] = search.outermost_reach();
  // The middles of chords of this length of the ball lie no farther out.
  const double farthest = std::sqrt(std::max(0.0, radius * radius - 0.25 * length * length));
  const Eigen::Vector3d middle =
      centre + farthest * std::cbrt(random.uniform()) * random_direction(random);
  return {"", middle - 0.5 * length * direction, middle + 0.5 * length * direction, lengths_mm};
}

}  // namespace

std::vector<PlannedSphere> sphere_places(const TouchSearch& search, const Shell& shell,
                                         const SphereToProbe& size, const SpherePattern& pattern,
                                         std::size_t most, RandomStream& random,
                                         TriedPlaces& tried) {
  std::vector<PlannedSphere> places;
  SphereToProbe sphere = size;
  int looked_at = 0;
  for (int i = 0; i < kPlacesToTry && looked_at < kPlacesLookedAt && places.size() < most; ++i) {
    sphere.centre_mm = random_point(search, shell, random);
    if (const auto fault = search.fault_at(sphere.centre_mm, sphere.radius_mm + kClearance_mm)) {
      tried.reject(*fault);
      continue;
    }
    ++looked_at;
    const auto poles = poles_at(search, sphere.centre_mm);
    const auto pole = std::find_if(poles.begin(), poles.end(), [&](const Eigen::Vector3d& each) {
      return reaches_all(search, sphere, pattern(each), random);
    });
    if (pole == poles.end()) {
      tried.reject("not reached from all sides");
    } else {
      tried.accept();
      places.push_back({"", sphere.centre_mm, *pole});
    }
  }
  return places;
}

std::optional<SeatPlace> seat_place(const TouchSearch& search, const Shell& shell,
                                    std::size_t postures, RandomStream& random,
                                    TriedPlaces& tried) {
  int looked_at = 0;
  for (int i = 0; i < kPlacesToTry && looked_at < kPlacesLookedAt; ++i) {
    const Eigen::Vector3d at = random_point(search, shell, random);
    if (const auto fault = search.fault_at(at, kClearance_mm)) {
      tried.reject(*fault);
      continue;
    }
    ++looked_at;
    for (const Eigen::Vector3d& axis : poles_at(search, at)) {
      if (!search.reaches({at, axis}, random)) continue;
      auto found = search.postures({at, axis}, kPosturesPerKept * postures,
                                   kStartsPerKept * static_cast<int>(postures), random);
      if (found.size() < postures) continue;
      return SeatPlace{{"", at, axis}, most_different(std::move(found), postures)};
    }
    tried.reject(fmt::format("not reached in {} postures", postures));
  }
  return std::nullopt;
}

std::vector<PlannedBar> bar_places(const TouchSearch& search, const Eigen::Vector3d& direction,
                                   const std::vector<double>& lengths_mm, std::size_t most,
                                   RandomStream& random, TriedPlaces& tried) {
  std::vector<PlannedBar> places;
  for (int i = 0; i < kBarTries && places.size() < most; ++i) {
    PlannedBar bar = random_bar(search, direction, lengths_mm, random);
    if (const auto fault = fault_of(search, bar)) {
      tried.reject(*fault);
    } else if (!reaches_ends(search, bar, random)) {
      tried.reject("not reached at every end");
    } else {
      tried.accept();
      places.push_back(std::move(bar));
    }
  }
  return places;
}

Touch seat_on(const TouchSearch& search, const PlannedBar& bar, double distance_from_A_mm) {
  const Eigen::Vector3d along = (bar.to_mm - bar.from_mm).normalized();
  const bool upright = std::abs(search.up().dot(along)) > kUprightCosine;
  const Eigen::Vector3d open =
      upright ? Eigen::Vector3d(-search.level_direction(0.5 * (bar.from_mm + bar.to_mm)))
              : search.up();
  return {bar.from_mm + distance_from_A_mm * along, (open - along * along.dot(open)).normalized()};
}

}  // namespace armcal
