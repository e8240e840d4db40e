// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/rigid_transform.h"

#include <Eigen/Geometry>
#include <cmath>

namespace armcal {

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(),  //
      a.z(), 0.0, -a.x(),        //
      -a.y(), a.x(), 0.0;
  return matrix;
}

Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& rotation_vector_rad) {
  const double squared = rotation_vector_rad.squaredNorm();
  const double angle = std::sqrt(squared);
  // sin(x)/x and (1-cos(x))/x^2: below 1e-4 rad two terms of the series are exact to rounding.
  const bool small = angle < 1e-4;
  const double sine = small ? 1.0 - squared / 6.0 : std::sin(angle) / angle;
  const double half = std::sin(angle / 2.0);
  const double cosine = small ? 0.5 - squared / 24.0 : 2.0 * half * half / squared;
  const Eigen::Matrix3d w = skew(rotation_vector_rad);
  return Eigen::Matrix3d::Identity() + sine * w + cosine * w * w;
}

Eigen::Vector3d vector_from_rotation(const Eigen::Matrix3d& rotation) {
  // By way of the quaternion, whose vector part keeps its digits at every angle.
  const Eigen::Quaterniond q(rotation);
  const double sine = q.vec().norm();
  if (sine == 0.0) return Eigen::Vector3d::Zero();
  const double angle = 2.0 * std::atan2(sine, std::abs(q.w()));
  return q.vec() * (std::copysign(angle, q.w()) / sine);
}

Eigen::Matrix3d rotation_about_z(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() << c, -s, s, c;
  return rotation;
}

Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& onto) {
  const Eigen::Vector3d cross = from.cross(onto);
  const double sine = cross.norm();
  const double angle = std::atan2(sine, from.dot(onto));
  const Eigen::Vector3d axis =
      sine > 0.0 ? Eigen::Vector3d(cross / sine) : perpendicular_pair(from).first;
  return rotation_from_vector(angle * axis);
}

Eigen::Matrix3d rotation_from_roll_pitch_yaw(const Eigen::Vector3d& roll_pitch_yaw_rad) {
  const double cr = std::cos(roll_pitch_yaw_rad.x());
  const double sr = std::sin(roll_pitch_yaw_rad.x());
  const double cp = std::cos(roll_pitch_yaw_rad.y());
  const double sp = std::sin(roll_pitch_yaw_rad.y());
  const double cy = std::cos(roll_pitch_yaw_rad.z());
  const double sy = std::sin(roll_pitch_yaw_rad.z());
  Eigen::Matrix3d rotation;
  rotation << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,          //
      -sp, cp * sr, cp * cr;
  return rotation;
}

Eigen::Vector3d roll_pitch_yaw_from_rotation(const Eigen::Matrix3d& rotation) {
  const double cosine_pitch = std::hypot(rotation(0, 0), rotation(1, 0));
  const double pitch = std::atan2(-rotation(2, 0), cosine_pitch);
  // Pitch within a hair of +-90 deg: the other two angles turn about the same axis, so roll is
  // chosen 0.
  if (cosine_pitch < 1e-15) {
    return {0.0, pitch, std::atan2(-rotation(0, 1), rotation(1, 1))};
  }
  // Near +-90 deg only the sum of roll and yaw is well determined: roll is what the yaw just found
  // leaves, or their errors, each 1e-16 / cos(pitch), would add up instead of cancelling.
  const double yaw = std::atan2(rotation(1, 0), rotation(0, 0));
  const double cy = std::cos(yaw);
  const double sy = std::sin(yaw);
  const double roll = std::atan2(sy * rotation(0, 2) - cy * rotation(1, 2),
                                 cy * rotation(1, 1) - sy * rotation(0, 1));
  return {roll, pitch, yaw};
}

PerpendicularPair perpendicular_pair(const Eigen::Vector3d& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  const Eigen::Vector3d first = axis.cross(Eigen::Vector3d::Unit(smallest)).normalized();
  return {first, axis.cross(first)};
}

Eigen::Vector3d with_largest_component_positive(const Eigen::Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction(largest) < 0.0 ? Eigen::Vector3d(-direction) : direction;
}

}  // namespace armcal
