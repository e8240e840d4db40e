// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

/// The axis of a joint as a line in space.
struct JointAxis {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< anywhere on it
  /// Of unit length; the angle of the joint grows right-handed about it.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Where the axes of an arm lie at a posture.
struct AxesAtPosture {
  std::vector<JointAxis> axes;  ///< one per joint
  Eigen::Vector3d tip_mm = Eigen::Vector3d::Zero();
  Eigen::VectorXd encoder_rad;
};

/// The axes and the tip of an arm, in its base frame.
[[nodiscard]] AxesAtPosture axes_at(const ArmModel& arm, const Eigen::VectorXd& encoder_rad);

struct ArmFromAxes {
  ArmModel arm;
  RigidTransform frame_from_base;  ///< frame: that of the axes
};

/// The arm that has these axes and this tip at this posture, in the parameters of another arm: its
/// counting directions, harmonics, base and limits. Exact. What axes and tip leave open (n + 2
/// conventions) is as in `pattern`: zero1 and the last zero, every d, the tip's d, and on each link
/// beta, or where the pattern's axes are within 10 deg of parallel its zero. alpha has the sign of
/// the pattern's, angles are those nearest to the pattern's. theory/kinematics.md eq. (14)-(17).
/// @return nothing where a link with the pattern's beta cannot join two axes
[[nodiscard]] std::optional<ArmFromAxes> arm_from_axes(const ArmModel& pattern,
                                                       const AxesAtPosture& at);

}  // namespace armcal
