// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

/// One joint in one posture: its rotation, and how its axis lies aside. Tilt (a rotation vector)
/// and shift are in the frame of the joint before its rotation.
struct JointState {
  double angle_rad = 0.0;
  Eigen::Vector3d tilt_rad = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift_mm = Eigen::Vector3d::Zero();
};

/// The rigid or bent part behind a joint: a link, or the probe behind the last joint. All vectors
/// are in the frame of the joint after its rotation.
struct LinkState {
  Eigen::Vector3d way_mm = Eigen::Vector3d::Zero();  ///< (a, b, d), to the next joint or the tip
  double alpha_rad = 0.0;
  double beta_rad = 0.0;
  Eigen::Vector3d bend_rad = Eigen::Vector3d::Zero();  ///< how its far end is turned by loads
  Eigen::Vector3d sag_mm = Eigen::Vector3d::Zero();    ///< how its far end is shifted by loads
};

/// An arm in one posture, number by number, so that every source of error can change what is its
/// own before the frames are multiplied up. theory/virtual_arm.md eq. (1)
struct ArmState {
  RigidTransform base_from_first_joint;
  std::vector<JointState> joints;  ///< n
  std::vector<LinkState> links;    ///< n; the last is the probe

  [[nodiscard]] int joint_count() const { return static_cast<int>(joints.size()); }
};

/// The posture without any disturbance.
[[nodiscard]] ArmState state_of(const ArmModel& arm, std::span<const double> encoder_rad);

/// Where the parts of an arm are.
struct ArmFrames {
  std::vector<RigidTransform> base_from_link;  ///< frame of each joint after its rotation
  Eigen::Vector3d tip_mm;                      ///< base frame
};

/// theory/virtual_arm.md eq. (1); without disturbance the tip of ForwardKinematics to rounding.
[[nodiscard]] ArmFrames frames_of(const ArmState& state);

}  // namespace armcal
