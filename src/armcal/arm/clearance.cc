// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/units.h"

namespace armcal {
namespace {

// Of the axis through the origin of the first joint: height along it and distance from it.
struct Place {
  double height_mm;
  double radius_mm;
};

Place place_of(const Eigen::Vector3d& point, const TipLinearisation& at) {
  const Eigen::Vector3d axis = at.joint_axes.col(0);
  const Eigen::Vector3d from_shoulder = point - at.joint_origins_mm.col(0);
  const double height = axis.dot(from_shoulder);
  return {height, (from_shoulder - height * axis).norm()};
}

// Smallest distance from the first axis on the part of a segment that is below `top`; infinite
// where no part is.
double nearest_below(const Place& from, const Place& to, const Eigen::Vector3d& a,
                     const Eigen::Vector3d& b, const TipLinearisation& at, double top_mm) {
  double low = 0.0;
  double high = 1.0;
  if (from.height_mm > top_mm && to.height_mm > top_mm) return HUGE_VAL;
  if (from.height_mm > top_mm) low = (from.height_mm - top_mm) / (from.height_mm - to.height_mm);
  if (to.height_mm > top_mm) high = (top_mm - from.height_mm) / (to.height_mm - from.height_mm);
  const Eigen::Vector3d axis = at.joint_axes.col(0);
  const auto across = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
    const Eigen::Vector3d d = point - at.joint_origins_mm.col(0);
    return d - axis.dot(d) * axis;
  };
  const Eigen::Vector3d start = across(a);
  const Eigen::Vector3d way = across(b) - start;
  const double length2 = way.squaredNorm();
  const double nearest = length2 > 0.0 ? std::clamp(-start.dot(way) / length2, low, high) : low;
  return (start + nearest * way).norm();
}

}  // namespace

std::optional<std::string> collision(const ForwardKinematics& kinematics,
                                     std::span<const double> encoder_rad,
                                     const Surroundings& surroundings) {
  if (!surroundings.bench_mm && surroundings.column_radius_mm <= 0.0) return std::nullopt;
  const TipLinearisation at = kinematics.linearise(encoder_rad);
  const int joints = kinematics.joint_count();
  const auto point = [&](int i) -> Eigen::Vector3d {
    return i < joints ? Eigen::Vector3d(at.joint_origins_mm.col(i)) : at.tip_mm;
  };
  const auto name = [&](int i) {
    return i < joints ? fmt::format("joint {}", i + 1) : std::string("the tip");
  };
  for (int i = 2; i <= joints; ++i) {
    const Place here = place_of(point(i), at);
    if (surroundings.bench_mm && here.height_mm < *surroundings.bench_mm) {
      return fmt::format("{} is {:.1f} mm below the bench", name(i),
                         *surroundings.bench_mm - here.height_mm);
    }
  }
  if (surroundings.column_radius_mm <= 0.0) return std::nullopt;
  for (int i = 2; i < joints; ++i) {
    const double nearest = nearest_below(place_of(point(i), at), place_of(point(i + 1), at),
                                         point(i), point(i + 1), at, surroundings.column_top_mm);
    if (nearest < surroundings.column_radius_mm) {
      return fmt::format(
          "the link from joint {} to {} passes {:.1f} mm from the first axis, inside "
          "the column of radius {:.1f} mm",
          i + 1, name(i + 1), nearest, surroundings.column_radius_mm);
    }
  }
  return std::nullopt;
}

std::optional<std::string> broken_limit(const ArmModel& arm, std::span<const double> encoder_rad) {
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
