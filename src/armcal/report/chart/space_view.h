// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>

namespace armcal {

/// Space as it is seen from far away: a parallel projection onto a drawing, y downwards.
class SpaceView {
 public:
  /// @param up           of unit length
  /// @param azimuth_rad  of the eye, about `up`
  /// @param elevation_rad  of the eye above the ground
  SpaceView(const Eigen::Vector3d& up, double azimuth_rad, double elevation_rad);

  /// Wants a point to be seen.
  void include(const Eigen::Vector3d& point);
  /// Brings everything that was included into a box of the drawing, as large as it will be, at its
  /// centre.
  void fit(double left, double top, double right, double bottom);

  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector3d& point) const;
  /// A direction: right, down, and towards the eye; not scaled.
  [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& vector) const;
  /// Larger is nearer to the eye.
  [[nodiscard]] double nearness(const Eigen::Vector3d& point) const { return toward_.dot(point); }
  [[nodiscard]] double scale() const { return scale_; }  ///< per mm
  [[nodiscard]] const Eigen::Vector3d& up() const { return up_; }

 private:
  Eigen::Vector3d up_, right_, upright_, toward_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high_ = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
  double scale_ = 1.0;
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero();
};

}  // namespace armcal
