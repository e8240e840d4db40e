// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/laser_tracker.h"

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/instruments/tracker_station.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const LaserTracker& tracker) {
  const TrackerNoise noise{tracker.u_distance_mm, tracker.u_angle_rad};
  ObservationGroup group = empty_group(ReferenceKind::reference_points, tracker.name, tracker.count,
                                       laboratory.arm().truth().joint_count(), 0.0);
  const RigidTransform reference_from_base = tracker_station(laboratory, tracker.distance_mm);
  group.reference_mm.resize(3, tracker.count);
  group.place.assign(static_cast<std::size_t>(tracker.count), tracker.name);
  for (int i = 0; i < tracker.count; ++i) {
    const TakenReading taken = laboratory.take(laboratory.free_posture());
    const Eigen::Vector3d point = reference_from_base * taken.tip_mm;
    group.encoder_rad.col(i) = taken.encoder_rad;
    group.reference_mm.col(i) = seen_by_tracker(point, noise, laboratory.random());
    const double u_mm = tracker_u_mm(point, noise);
    if (u_mm > 0.0) group.u_mm(i) = u_mm;
  }
  return {group};
}

}  // namespace armcal
