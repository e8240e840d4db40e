// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/articulations.h"

#include <algorithm>
#include <cmath>

#include "armcal/core/invariant.h"
#include "armcal/simulation/posture_choice.h"

namespace armcal {
namespace {

// The articulation that a start leads to.
std::optional<Articulation> articulation_from(const TouchSearch& search,
                                              const SphereToProbe& sphere,
                                              const Eigen::Vector3d& pole,
                                              const Eigen::VectorXd& start_rad) {
  const Touch centre{sphere.centre_mm, Eigen::Vector3d::Zero()};
  const auto middle = search.posture_near(centre, start_rad);
  if (!middle) return std::nullopt;
  Articulation result;
  const Eigen::Vector3d towards_arm = -search.stylus_direction(*middle);
  if (towards_arm.isZero() || towards_arm.dot(pole) < 0.0) return std::nullopt;
  for (const Eigen::Vector3d& direction : pattern_of_5(towards_arm)) {
    const Touch touch = sphere.touch(direction);
    const auto posture = search.posture_near(touch, *middle);
    if (!posture || search.fault_at(touch.tip_mm)) return std::nullopt;
    const Eigen::Vector3d stylus = search.stylus_direction(*posture);
    if (result.touches.empty()) result.stylus = stylus;
    if (stylus.dot(result.stylus) < kSteadyCosine) return std::nullopt;
    result.touches.push_back(touch);
    result.postures_rad.push_back(*posture);
  }
  result.elbow_mm = search.elbow_mm(result.postures_rad.front());
  return result;
}

double distance_rad(const Articulation& one, const Articulation& other) {
  return joint_distance_rad(one.postures_rad.front(), other.postures_rad.front());
}

// The two to begin with, in front.
void begin_with_both_elbows(std::vector<Articulation>& candidates) {
  double farthest = -1.0;
  std::pair<std::size_t, std::size_t> best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      if (candidates[i].elbow_mm * candidates[k].elbow_mm >= 0.0) continue;
      const double distance = distance_rad(candidates[i], candidates[k]);
      if (distance <= farthest) continue;
      farthest = distance;
      best = {i, k};
    }
  }
  if (farthest < 0.0) return;
  // i < k, so the first exchange moves neither what the second one brings nor where it goes.
  std::swap(candidates[0], candidates[best.first]);
  std::swap(candidates[1], candidates[best.second]);
}

}  // namespace

std::vector<Articulation> articulations_at(const TouchSearch& search, const SphereToProbe& sphere,
                                           const Eigen::Vector3d& pole, int starts,
                                           RandomStream& random) {
  std::vector<Articulation> found;
  for (int i = 0; i < starts; ++i) {
    auto articulation = articulation_from(search, sphere, pole, search.random_posture(random));
    if (articulation) found.push_back(std::move(*articulation));
  }
  return found;
}

std::vector<Articulation> choose_articulations(std::vector<Articulation> candidates,
                                               std::size_t count) {
  ARMCAL_INVARIANT(count >= 2 && count <= candidates.size());
  begin_with_both_elbows(candidates);
  const auto nearest_of = [&](const Articulation& candidate, std::size_t chosen) {
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < chosen; ++i) {
      nearest = std::min(nearest, distance_rad(candidate, candidates[i]));
    }
    return nearest;
  };
  const bool has_pair = candidates[0].elbow_mm * candidates[1].elbow_mm < 0.0;
  for (std::size_t chosen = has_pair ? 2 : 1; chosen < count; ++chosen) {
    std::size_t best = chosen;
    for (std::size_t i = chosen + 1; i < candidates.size(); ++i) {
      if (nearest_of(candidates[i], chosen) > nearest_of(candidates[best], chosen)) best = i;
    }
    std::swap(candidates[chosen], candidates[best]);
  }
  candidates.resize(count);
  return candidates;
}

double least_distance_rad(const std::vector<Articulation>& articulations) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < articulations.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      least = std::min(least, distance_rad(articulations[i], articulations[k]));
    }
  }
  return least;
}

}  // namespace armcal
