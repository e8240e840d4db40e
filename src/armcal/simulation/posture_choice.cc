// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/posture_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "armcal/core/invariant.h"

namespace armcal {
namespace {

using std::numbers::pi;

}  // namespace

JointRange range_in_use(const Joint& joint) {
  const bool has_low = std::isfinite(joint.min_rad);
  const bool has_high = std::isfinite(joint.max_rad);
  if (has_low && has_high) {
    const double middle = 0.5 * (joint.min_rad + joint.max_rad);
    return {std::max(joint.min_rad, middle - pi), std::min(joint.max_rad, middle + pi)};
  }
  if (has_low) return {joint.min_rad, joint.min_rad + 2.0 * pi};
  if (has_high) return {joint.max_rad - 2.0 * pi, joint.max_rad};
  return {-pi, pi};
}

double joint_distance_rad(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < one.size(); ++i) {
    const double turn = std::remainder(one(i) - other(i), 2.0 * pi);
    sum += turn * turn;
  }
  return std::sqrt(sum);
}

std::vector<Eigen::VectorXd> most_different(std::vector<Eigen::VectorXd> candidates,
                                            std::size_t count) {
  ARMCAL_INVARIANT(count <= candidates.size());
  std::vector<double> distance(candidates.size(), std::numeric_limits<double>::infinity());
  for (std::size_t chosen = 0; chosen < count; ++chosen) {
    // The chosen ones stand in front; `distance` is that from the nearest of them.
    const auto farthest =
        std::max_element(distance.begin() + static_cast<std::ptrdiff_t>(chosen), distance.end()) -
        distance.begin();
    std::swap(candidates[chosen], candidates[static_cast<std::size_t>(farthest)]);
    std::swap(distance[chosen], distance[static_cast<std::size_t>(farthest)]);
    for (std::size_t i = chosen + 1; i < candidates.size(); ++i) {
      distance[i] = std::min(distance[i], joint_distance_rad(candidates[i], candidates[chosen]));
    }
  }
  candidates.resize(count);
  return candidates;
}

}  // namespace armcal
