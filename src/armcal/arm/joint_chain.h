// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

/// A turning joint as robot descriptions state it: a frame of its own, at any place, and an axis of
/// any direction through its origin.
struct ChainJoint {
  RigidTransform parent_from_joint;                          ///< at reading 0
  Eigen::Vector3d axis_in_joint = Eigen::Vector3d::UnitZ();  ///< of unit length
  double min_rad = -std::numeric_limits<double>::infinity();
  double max_rad = std::numeric_limits<double>::infinity();
};

/// base_from_tip = product of parent_from_joint * Rot(axis, q), then last_from_tip.
///   theory/kinematics.md eq. (12)
struct JointChain {
  std::string name;
  std::string note;
  std::vector<ChainJoint> joints;
  RigidTransform last_from_tip;
};

/// Pose of the tip at joint readings `q`, straight from the definition.
[[nodiscard]] RigidTransform base_from_tip(const JointChain& chain, std::span<const double> q_rad);

/// The same poses as links. Exact for every chain: the origins of the joints stay where they are,
/// so no common normal is sought and no link is longer than the way from origin to origin. Frames
/// are turned about their axes so that beta is 0; where axes are within 10 deg of parallel so that
/// b is 0, and beta says what is missing to parallel (Hayati).   theory/kinematics.md eq. (13)
[[nodiscard]] ArmModel arm_from_chain(const JointChain& chain);

struct ChainConversion {
  JointChain chain;
  std::vector<std::string> lost;  ///< what a chain cannot say, in words: harmonics
};

/// The same poses as a chain whose joint values are the readings of the encoders: zero offsets go
/// into the places of the joints; a joint that counts backwards turns about -z.
[[nodiscard]] ChainConversion chain_from_arm(const ArmModel& arm);

}  // namespace armcal
