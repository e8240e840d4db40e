// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/arm/forward_kinematics.h"

namespace armcal {

struct PostureSearchOptions {
  std::vector<int> joints;     ///< that may move, from 1; empty: all
  double tolerance_mm = 1e-9;  ///< distance at which the tip has arrived
  int max_iterations = 200;
  double largest_step_rad = 0.2;  ///< of any joint in one iteration
};

/// A posture found, and how near it came.
struct PostureSearch {
  bool found = false;
  Eigen::VectorXd encoder_rad;
  double miss_mm = 0.0;  ///< distance of the tip from where it should be
};

/// Encoder readings near `start_rad` that put the tip on a point: damped Newton steps of least
/// motion (an arm with more joints than it needs moves no more than it must). theory/kinematics.md
/// eq. (14)
/// @param point_mm  in the base frame
[[nodiscard]] PostureSearch find_posture(const ForwardKinematics& kinematics,
                                         const Eigen::Vector3d& point_mm,
                                         const Eigen::VectorXd& start_rad,
                                         const PostureSearchOptions& options = {});

}  // namespace armcal
