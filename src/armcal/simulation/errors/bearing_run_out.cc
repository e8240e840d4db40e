// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/bearing_run_out.h"

#include <cmath>

#include "armcal/core/units.h"

namespace armcal {

BearingRunOut BearingRunOut::typical() {
  return {.u_tilt_rad = radians_from_arcseconds(1.0), .u_shift_mm = 0.0005};
}

std::vector<RunOutOfJoint> drawn_run_out(int joint_count, const BearingRunOut& run_out,
                                         RandomStream& random) {
  std::vector<RunOutOfJoint> drawn(static_cast<std::size_t>(joint_count));
  for (RunOutOfJoint& joint : drawn) {
    for (Eigen::Index row = 0; row < joint.rows(); ++row) {
      const double size = row < 2 ? run_out.u_tilt_rad : run_out.u_shift_mm;
      for (Eigen::Index column = 0; column < joint.cols(); ++column) {
        joint(row, column) = (column < 2 ? size : 0.5 * size) * random.normal();
      }
    }
  }
  return drawn;
}

void add_run_out(ArmState& state, const std::vector<RunOutOfJoint>& run_out) {
  for (std::size_t i = 0; i < run_out.size(); ++i) {
    JointState& joint = state.joints[i];
    const double t = joint.angle_rad;
    const Eigen::Vector4d waves(std::cos(t), std::sin(t), std::cos(2.0 * t), std::sin(2.0 * t));
    const Eigen::Matrix<double, 5, 1> off = run_out[i] * waves;
    joint.tilt_rad.head<2>() += off.head<2>();
    joint.shift_mm += off.tail<3>();
  }
}

}  // namespace armcal
