// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/pose_tracker.h"

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/instruments/tracker_station.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const PoseTracker& tracker) {
  ObservationGroup group = empty_group(ReferenceKind::reference_poses, tracker.name, tracker.count,
                                       laboratory.arm().truth().joint_count(), tracker.u_mm);
  const RigidTransform reference_from_base = tracker_station(laboratory, tracker.distance_mm);
  const Eigen::Matrix3d last_joint_from_target = laboratory.convenient_place(0.0).rotation;
  group.reference_mm.resize(3, tracker.count);
  group.place.assign(static_cast<std::size_t>(tracker.count), tracker.name);
  if (tracker.u_mm > 0.0 && tracker.u_turn_rad > 0.0) {
    group.lever_mm = tracker.u_mm / tracker.u_turn_rad;
  }
  for (int i = 0; i < tracker.count; ++i) {
    const TakenReading taken = laboratory.take(laboratory.free_posture());
    group.encoder_rad.col(i) = taken.encoder_rad;
    group.reference_mm.col(i) = reference_from_base * taken.tip_mm + laboratory.noise(tracker.u_mm);
    group.orientation.emplace_back(rotation_from_vector(laboratory.noise(tracker.u_turn_rad)) *
                                   reference_from_base.rotation * taken.base_from_last_joint *
                                   last_joint_from_target);
  }
  return {group};
}

}  // namespace armcal
