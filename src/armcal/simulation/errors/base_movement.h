// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/core/random.h"
#include "armcal/geometry/rigid_transform.h"
#include "armcal/simulation/arm_state.h"

namespace armcal {

/// A foot that does not stand still: it moves a little from reading to reading, and it tilts to
/// where the arm leans. Movements are about the origin of the first joint.
/// theory/virtual_arm.md eq. (12)-(13)
struct BaseMovement {
  double u_shift_mm = 0.0;         ///< standard deviation of each coordinate, reading by reading
  double u_tilt_rad = 0.0;         ///< and of the rotation about each axis
  double load_kg = 0.0;            ///< arm and hand, half way between the first joint and the tip
  double tilt_rad_per_N_mm = 0.0;  ///< of the foot on its support

  [[nodiscard]] bool is_random() const { return u_shift_mm > 0.0 || u_tilt_rad > 0.0; }
  [[nodiscard]] bool tilts() const { return load_kg > 0.0 && tilt_rad_per_N_mm > 0.0; }
  [[nodiscard]] bool is_on() const { return is_random() || tilts(); }
  /// 1 um, 0.5 arcsec, and 5 kg on a support of 1e6 N m/rad. An estimate: makers only warn that the
  /// angle grows with the reach.
  [[nodiscard]] static BaseMovement typical();
};

/// Movement of the foot during one reading.
[[nodiscard]] RigidTransform drawn_movement(const BaseMovement& base, RandomStream& random);

void add_movement(ArmState& state, const RigidTransform& movement);

/// Tilts the foot to where the arm leans. @param down  of gravity, base frame, of unit length
void add_tilt(ArmState& state, const BaseMovement& base, const Eigen::Vector3d& down);

}  // namespace armcal
