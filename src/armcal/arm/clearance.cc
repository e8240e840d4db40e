// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armcal/core/invariant.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

// A point as seen from the first axis.
struct Footpoint {
  double height_mm;           // along it, from the origin of the first joint
  Eigen::Vector3d across_mm;  // away from it
};

// Origins of the joints, then the tip.
std::vector<Footpoint> places(const TipLinearisation& at) {
  const Eigen::Vector3d axis = at.joint_axes.col(0);
  const Eigen::Vector3d foot = at.joint_origins_mm.col(0);
  const auto place_of = [&](const Eigen::Vector3d& point) -> Footpoint {
    const double height = axis.dot(point - foot);
    return {height, point - foot - height * axis};
  };
  std::vector<Footpoint> result;
  for (const auto& origin : at.joint_origins_mm.colwise()) result.push_back(place_of(origin));
  result.push_back(place_of(at.tip_mm));
  return result;
}

// Index of the first place that can run into something.
std::size_t elbow(const std::vector<Footpoint>& places) {
  std::vector<double> way = {0.0, 0.0};  // from the second joint; the same in every posture
  for (std::size_t i = 2; i < places.size(); ++i) {
    const double rise = places[i].height_mm - places[i - 1].height_mm;
    way.push_back(way.back() +
                  std::hypot(rise, (places[i].across_mm - places[i - 1].across_mm).norm()));
  }
  std::size_t i = 2;
  while (i + 1 < places.size() && way[i] <= 0.25 * way.back()) ++i;
  return i;
}

// Smallest distance from the first axis on the part of a link that is below `top_mm`; infinite
// where no part is.
double nearest_below(const Footpoint& from, const Footpoint& to, double top_mm) {
  const double above_from = from.height_mm - top_mm;
  const double above_to = to.height_mm - top_mm;
  if (above_from > 0.0 && above_to > 0.0) return HUGE_VAL;
  const double low = above_from > 0.0 ? above_from / (above_from - above_to) : 0.0;
  const double high = above_to > 0.0 ? above_from / (above_from - above_to) : 1.0;
  const Eigen::Vector3d way = to.across_mm - from.across_mm;
  const double length2 = way.squaredNorm();
  const double foot_of_normal = length2 > 0.0 ? -from.across_mm.dot(way) / length2 : low;
  return (from.across_mm + std::clamp(foot_of_normal, low, high) * way).norm();
}

}  // namespace

std::optional<std::string> collision(const ForwardKinematics& kinematics,
                                     std::span<const double> encoder_rad,
                                     const Surroundings& surroundings) {
  if (!surroundings.bench_mm && surroundings.column_radius_mm <= 0.0) return std::nullopt;
  const std::vector<Footpoint> at = places(kinematics.linearise(encoder_rad));
  const auto name = [&](std::size_t i) {
    return i + 1 < at.size() ? fmt::format("joint {}", i + 1) : std::string("the tip");
  };
  const std::size_t first = elbow(at);
  for (std::size_t i = first; i < at.size() && surroundings.bench_mm; ++i) {
    const double below = *surroundings.bench_mm - at[i].height_mm;
    if (below > 0.0) return fmt::format("{} is {:.1f} mm below the bench", name(i), below);
  }
  for (std::size_t i = first; i < at.size(); ++i) {
    // The last round looks at the tip alone, which is all there is of an arm without an elbow.
    const std::size_t next = std::min(i + 1, at.size() - 1);
    const double nearest = nearest_below(at[i], at[next], surroundings.column_top_mm);
    if (nearest >= surroundings.column_radius_mm) continue;
    return fmt::format(
        "{} passes {:.1f} mm from the first axis, inside the column of radius {:.1f} mm",
        i == next ? name(i) : fmt::format("the link from {} to {}", name(i), name(next)), nearest,
        surroundings.column_radius_mm);
  }
  return std::nullopt;
}

std::optional<std::string> broken_limit(const ArmModel& arm, std::span<const double> encoder_rad) {
  ARMCAL_INVARIANT(encoder_rad.size() == arm.joints.size());
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    const bool below = encoder_rad[i] < joint.min_rad;
    if (!below && encoder_rad[i] <= joint.max_rad) continue;
    return fmt::format("joint {} at {:.1f} deg is beyond its limit of {:.1f} deg", i + 1,
                       degrees_from_radians(encoder_rad[i]),
                       degrees_from_radians(below ? joint.min_rad : joint.max_rad));
  }
  return std::nullopt;
}

}  // namespace armcal
