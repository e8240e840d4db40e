// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// How a circle-point analysis ended. Only `found` is a result; `detail` names joint and numbers.
enum class CirclePointStatus {
  found,
  joint_without_arc,  ///< at least three points per joint
  other_joint_moved,  ///< joints that should stand at home did not
  not_a_circle,       ///< the points of a joint are off every circle
  arc_too_short,      ///< its points leave the axis open
  tip_on_axis,        ///< the tip is so near the axis that there is no circle
  encoder_disagrees,  ///< the points turn by other angles than the encoder
  arcs_disagree,      ///< turned back to home, the points of two joints are at different places
  unlike_nominal,     ///< axes that no small change of the nominal arm has
};
[[nodiscard]] std::string_view explain(CirclePointStatus status);

/// The tip while one joint turns and the rest stand still.
struct JointArc {
  int joint = 0;                           ///< from 1
  std::vector<Eigen::Vector3d> points_mm;  ///< at least 3
  /// Angle of the encoder from home, corrected by its harmonics, at each point.
  std::vector<double> turned_rad;
  double u_mm = 0.0;  ///< standard uncertainty of a coordinate
};

/// The axis of a joint, in the frame of the reference machine.
struct MeasuredAxis {
  Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();  ///< of the circle of the tip
  /// Of unit length; the encoder counts up right-handed about it.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  double radius_mm = 0.0;
  double rms_mm = 0.0;    ///< of the points off the circle
  double span_rad = 0.0;  ///< of the encoder
  /// Of x y z of the centre, then of the direction, from the stated uncertainty of the points.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double u_center_mm = 0.0;      ///< in the direction known worst
  double u_direction_rad = 0.0;  ///< about the direction known worst
};

struct CircleAxis {
  CirclePointStatus status = CirclePointStatus::found;
  std::string detail;
  MeasuredAxis axis;

  [[nodiscard]] bool ok() const { return status == CirclePointStatus::found; }
};

/// The axis of the circle (geometry/circle.h) of an arc, and the sense in which it is turned about.
/// @param largest_u_direction_rad  an axis that is known no better is refused
[[nodiscard]] CircleAxis axis_of(const JointArc& arc, double largest_u_direction_rad);

/// Where the arc's points are once they are turned back to home: their mean, that is the tip at
/// home as this joint sees it.
[[nodiscard]] Eigen::Vector3d tip_at_home(const JointArc& arc, const MeasuredAxis& axis);

}  // namespace armcal
