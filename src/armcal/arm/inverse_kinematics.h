// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/arm/forward_kinematics.h"

namespace armcal {

/// Range of each encoder reading.
struct JointLimits {
  Eigen::VectorXd min_rad;
  Eigen::VectorXd max_rad;
};

/// Limits of an arm as its joints state them; infinite where there is no stop.
[[nodiscard]] JointLimits joint_limits(const ArmModel& arm);

/// The same posture inside the limits: joints that are beyond one are turned by whole turns where
/// that brings them inside, else moved to the nearer limit (which changes the posture).
[[nodiscard]] Eigen::VectorXd brought_inside(const Eigen::VectorXd& encoder_rad,
                                             const JointLimits& limits);

struct PostureSearchOptions {
  std::vector<int> joints;     ///< that may move, from 1; empty: all
  double tolerance_mm = 1e-9;  ///< distance at which the tip has arrived
  int max_iterations = 200;
  double largest_step_rad = 0.2;  ///< of any joint in one iteration
  /// Joints that may move stay inside; empty vectors: no limits.
  JointLimits limits = {};
  /// How often to begin anew, from postures spread over the ranges of the joints that may move (one
  /// turn where there is no stop), where the search from the start does not arrive.
  int restarts = 0;
};

/// A posture found, and how near it came.
struct PostureSearch {
  bool found = false;
  Eigen::VectorXd encoder_rad;
  double miss_mm = 0.0;  ///< distance of the tip from where it should be
};

/// Encoder readings near `start_rad` that put the tip on a point: damped Newton steps of least
/// motion (an arm with more joints than it needs moves no more than it must). Where the point is
/// out of reach, or where limits bar the way, the posture is the one nearest to it that was seen.
/// theory/kinematics.md eq. (14)-(15)
/// @param point_mm  in the base frame
/// @param start_rad  brought inside the limits first
[[nodiscard]] PostureSearch find_posture(const ForwardKinematics& kinematics,
                                         const Eigen::Vector3d& point_mm,
                                         const Eigen::VectorXd& start_rad,
                                         const PostureSearchOptions& options = {});

}  // namespace armcal
