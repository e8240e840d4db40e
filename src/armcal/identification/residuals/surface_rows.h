// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// Points of a block with their derivatives, for residuals that are one number per point: its
/// derivative by the arm's columns (and the target's) is a direction times that of the point.
class PointBlock {
 public:
  PointBlock(const MeasuredPoint& measured, const ArmAt& at, const Unknowns& unknowns,
             const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index count);

  [[nodiscard]] Eigen::Vector3d point(Eigen::Index k) const {
    return Eigen::Map<const Eigen::Vector3d>(points_.data() + 3 * k);
  }
  /// row[i] = direction . d(point k)/d(column i)
  void project(Eigen::Index k, const Eigen::Vector3d& direction, double* row) const;

 private:
  Eigen::Index columns_;
  std::vector<double> points_;
  std::vector<double> derivatives_;
};

[[nodiscard]] std::vector<Eigen::Vector3d> columns_of(const Eigen::Matrix3Xd& points);

}  // namespace armcal
