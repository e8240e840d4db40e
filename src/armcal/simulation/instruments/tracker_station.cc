// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/tracker_station.h"

#include <cmath>
#include <numbers>

namespace armcal {

RigidTransform tracker_station(Laboratory& laboratory, double distance_mm) {
  using std::numbers::pi;
  // Trackers stand upright, their head about as high as the shoulder of the arm.
  constexpr double kHeightRange_mm = 500.0;
  RandomStream& random = laboratory.random();
  const double side_rad = random.uniform(-pi, pi);
  const double height_mm = random.uniform(-kHeightRange_mm, kHeightRange_mm);
  const RigidTransform first_joint_from_tracker{
      rotation_from_vector(random.uniform(-pi, pi) * Eigen::Vector3d::UnitZ()),
      {distance_mm * std::cos(side_rad), distance_mm * std::sin(side_rad), height_mm}};
  return (laboratory.arm().truth().base_from_first_joint * first_joint_from_tracker).inverse();
}

Eigen::Vector3d seen_by_tracker(const Eigen::Vector3d& point_mm, const TrackerNoise& noise,
                                RandomStream& random) {
  const double distance = point_mm.norm() + noise.u_distance_mm * random.normal();
  const double azimuth =
      std::atan2(point_mm.y(), point_mm.x()) + noise.u_angle_rad * random.normal();
  const double elevation = std::atan2(point_mm.z(), std::hypot(point_mm.x(), point_mm.y())) +
                           noise.u_angle_rad * random.normal();
  return {distance * std::cos(elevation) * std::cos(azimuth),
          distance * std::cos(elevation) * std::sin(azimuth), distance * std::sin(elevation)};
}

double tracker_u_mm(const Eigen::Vector3d& point_mm, const TrackerNoise& noise) {
  const double up_mm = noise.u_angle_rad * point_mm.norm();
  const double aside_mm = noise.u_angle_rad * std::hypot(point_mm.x(), point_mm.y());
  return std::sqrt(
      (noise.u_distance_mm * noise.u_distance_mm + up_mm * up_mm + aside_mm * aside_mm) / 3.0);
}

}  // namespace armcal
