// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/space_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "armcal/geometry/rigid_transform.h"

namespace armcal {

SpaceView::SpaceView(const Eigen::Vector3d& up, double azimuth_rad, double elevation_rad)
    : up_(up) {
  // From x as far as that is across.
  const Eigen::Vector3d across = Eigen::Vector3d::UnitX() - up.x() * up;
  const Eigen::Vector3d first =
      across.norm() > 0.1 ? Eigen::Vector3d(across.normalized()) : perpendicular_pair(up).first;
  const Eigen::Vector3d second = up.cross(first);
  const Eigen::Vector3d level = std::cos(azimuth_rad) * first + std::sin(azimuth_rad) * second;
  toward_ = std::cos(elevation_rad) * level + std::sin(elevation_rad) * up;
  right_ = up.cross(level);
  upright_ = toward_.cross(right_);
}

void SpaceView::include(const Eigen::Vector3d& point) {
  if (!point.allFinite()) return;
  const Eigen::Vector2d seen(right_.dot(point), -upright_.dot(point));
  low_ = low_.cwiseMin(seen);
  high_ = high_.cwiseMax(seen);
}

void SpaceView::fit(double left, double top, double right, double bottom) {
  if (!(low_.x() <= high_.x())) return;
  const Eigen::Vector2d size = (high_ - low_).cwiseMax(1e-6);
  scale_ = std::min((right - left) / size.x(), (bottom - top) / size.y());
  offset_ = 0.5 * Eigen::Vector2d(left + right, top + bottom) - scale_ * 0.5 * (low_ + high_);
}

Eigen::Vector2d SpaceView::at(const Eigen::Vector3d& point) const {
  return scale_ * Eigen::Vector2d(right_.dot(point), -upright_.dot(point)) + offset_;
}

Eigen::Vector3d SpaceView::direction(const Eigen::Vector3d& vector) const {
  return {right_.dot(vector), -upright_.dot(vector), toward_.dot(vector)};
}

}  // namespace armcal
