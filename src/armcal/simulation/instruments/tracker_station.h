// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// Where a tracker stands: some metres from the first axis, upright, on any side.
/// @return reference_from_base
[[nodiscard]] RigidTransform tracker_station(Laboratory& laboratory, double distance_mm);

/// What a tracker is uncertain by: a distance and two angles.
struct TrackerNoise {
  double u_distance_mm = 0.0;
  double u_angle_rad = 0.0;
};

/// A point as the tracker measures it, both in its frame.
[[nodiscard]] Eigen::Vector3d seen_by_tracker(const Eigen::Vector3d& point_mm,
                                              const TrackerNoise& noise, RandomStream& random);
/// Root of the mean variance of the three coordinates of such a point.
[[nodiscard]] double tracker_u_mm(const Eigen::Vector3d& point_mm, const TrackerNoise& noise);

}  // namespace armcal
