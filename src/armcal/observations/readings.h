// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace armcal {

/// Encoder readings, one posture per column, rows the joints.
struct JointReadings {
  std::string file;
  Eigen::MatrixXd encoder_rad;
  std::vector<int> lines;  ///< line of the file that each posture came from

  [[nodiscard]] Eigen::Index count() const { return encoder_rad.cols(); }
  [[nodiscard]] std::span<const double> posture(Eigen::Index index) const {
    return {encoder_rad.col(index).data(), static_cast<std::size_t>(encoder_rad.rows())};
  }
};

/// Coordinates, one point per entry.
struct PointReadings {
  std::string file;
  bool planar = false;  ///< only x and y were given; z is 0
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<std::string> names;  ///< from a column `point`; empty without one
  std::vector<int> lines;
};

}  // namespace armcal
