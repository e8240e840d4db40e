// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/core/random.h"
#include "armcal/simulation/arm_state.h"

namespace armcal {

/// Bearings that let an axis wander as it turns: tilt and shift with the angle of the joint, once
/// and twice per turn. theory/virtual_arm.md eq. (4)
///
/// What of it turns with the joint once per turn is a link that is a little different and is found
/// by a calibration; the rest is not.
struct BearingRunOut {
  double u_tilt_rad = 0.0;  ///< standard deviation of each amplitude; half of it twice per turn
  double u_shift_mm = 0.0;  ///< across and along the axis, likewise

  [[nodiscard]] bool is_on() const { return u_tilt_rad > 0.0 || u_shift_mm > 0.0; }
  /// 1 arcsec and 0.5 um: pairs of precision bearings. An estimate; what is published is the sum of
  /// bearings, encoders and heat.
  [[nodiscard]] static BearingRunOut typical();
};

/// Rows: tilt about x and y of the frame before the rotation (rad), shift along x, y, z (mm).
/// Columns: factors of cos t, sin t, cos 2t, sin 2t, with t the angle of the joint.
using RunOutOfJoint = Eigen::Matrix<double, 5, 4>;

[[nodiscard]] std::vector<RunOutOfJoint> drawn_run_out(int joint_count,
                                                       const BearingRunOut& run_out,
                                                       RandomStream& random);

/// Moves the axes of all joints to where their angles have them.
void add_run_out(ArmState& state, const std::vector<RunOutOfJoint>& run_out);

}  // namespace armcal
