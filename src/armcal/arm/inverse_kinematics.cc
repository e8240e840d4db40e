// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/inverse_kinematics.h"

#include <numeric>

#include "armcal/numerics/linear_algebra.h"

namespace armcal {

PostureSearch find_posture(const ForwardKinematics& kinematics, const Eigen::Vector3d& point_mm,
                           const Eigen::VectorXd& start_rad, const PostureSearchOptions& options) {
  std::vector<int> joints = options.joints;
  if (joints.empty()) {
    joints.resize(static_cast<std::size_t>(kinematics.joint_count()));
    std::iota(joints.begin(), joints.end(), 1);
  }
  PostureSearch search;
  search.encoder_rad = start_rad;
  TipLinearisation at;
  Eigen::MatrixXd jacobian(3, static_cast<Eigen::Index>(joints.size()));
  for (int i = 0;; ++i) {
    kinematics.linearise(
        {search.encoder_rad.data(), static_cast<std::size_t>(search.encoder_rad.size())}, at);
    const Eigen::Vector3d missing = point_mm - at.tip_mm;
    search.miss_mm = missing.norm();
    search.found = search.miss_mm <= options.tolerance_mm;
    if (search.found || i == options.max_iterations) return search;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      jacobian.col(static_cast<Eigen::Index>(k)) = at.J_tip_encoder.col(joints[k] - 1);
    }
    Eigen::VectorXd step = shortest_solution(jacobian, missing);
    const double largest = step.lpNorm<Eigen::Infinity>();
    if (largest > options.largest_step_rad) step *= options.largest_step_rad / largest;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      search.encoder_rad(joints[k] - 1) += step(static_cast<Eigen::Index>(k));
    }
  }
}

}  // namespace armcal
