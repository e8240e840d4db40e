// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/base_movement.h"

#include <Eigen/Geometry>

#include "armcal/core/units.h"
#include "armcal/simulation/errors/gravity_sag.h"

namespace armcal {

BaseMovement BaseMovement::typical() {
  return {.u_shift_mm = 0.001,
          .u_tilt_rad = radians_from_arcseconds(0.5),
          .load_kg = 5.0,
          .tilt_rad_per_N_mm = 1e-9};
}

RigidTransform drawn_movement(const BaseMovement& base, RandomStream& random) {
  if (!base.is_random()) return {};
  RigidTransform movement;
  Eigen::Vector3d turn;
  for (double& component : turn) component = base.u_tilt_rad * random.normal();
  for (double& component : movement.translation_mm) component = base.u_shift_mm * random.normal();
  movement.rotation = rotation_from_vector(turn);
  return movement;
}

void add_movement(ArmState& state, const RigidTransform& movement) {
  RigidTransform& base = state.base_from_first_joint;
  base.rotation = movement.rotation * base.rotation;
  base.translation_mm += movement.translation_mm;
}

void add_tilt(ArmState& state, const BaseMovement& base, const Eigen::Vector3d& down) {
  const Eigen::Vector3d lever =
      0.5 * (frames_of(state).tip_mm - state.base_from_first_joint.translation_mm);
  const Eigen::Vector3d moment = lever.cross(base.load_kg * kGravity_m_per_s2 * down);
  add_movement(state,
               {rotation_from_vector(base.tilt_rad_per_N_mm * moment), Eigen::Vector3d::Zero()});
}

}  // namespace armcal
