// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/circle_axis.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "armcal/core/units.h"
#include "armcal/geometry/circle.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {
namespace {

// A blunder: no encoder and no bearing is that bad.
constexpr double kBlunder_rad = 0.02;

// In the direction known worst.
double largest_u(const Eigen::Matrix3d& covariance) {
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().maxCoeff());
}

CircleAxis refused(const JointArc& arc, const MeasuredAxis& axis, FitStatus status) {
  const bool no_axis = status == FitStatus::points_coincide ||
                       status == FitStatus::points_are_collinear ||
                       status == FitStatus::radius_unbounded;
  const std::string which =
      fmt::format("joint {}, turned by {:.1f} deg", arc.joint, degrees_from_radians(axis.span_rad));
  if (!no_axis) {
    return {CirclePointStatus::not_a_circle, fmt::format("{}: {}", which, explain(status)), axis};
  }
  const std::string known =
      axis.radius_mm > 0.0
          ? fmt::format("on a circle of {:.3f} mm radius its axis is known to {:.3f} deg",
                        axis.radius_mm, degrees_from_radians(axis.u_direction_rad))
          : std::string(explain(status));
  // A tip beside the axis would have drawn a circle over such an angle.
  const bool is_wide = axis.span_rad > std::numbers::pi / 2.0;
  return {is_wide ? CirclePointStatus::tip_on_axis : CirclePointStatus::arc_too_short,
          fmt::format("{}: {}", which, known), axis};
}

// Mean of the unit vectors from where the encoder says to where the points are: its angle is that
// of home, its length 1 where all agree.
std::complex<double> agreement(const JointArc& arc, const MeasuredAxis& axis, double sense) {
  const auto [x, y] = perpendicular_pair(axis.direction);
  std::complex<double> sum;
  for (std::size_t k = 0; k < arc.points_mm.size(); ++k) {
    const Eigen::Vector3d radial = arc.points_mm[k] - axis.center_mm;
    sum += std::polar(1.0, std::atan2(radial.dot(y), radial.dot(x)) - sense * arc.turned_rad[k]);
  }
  return sum / static_cast<double>(arc.points_mm.size());
}

}  // namespace

CircleAxis axis_of(const JointArc& arc, double largest_u_direction_rad) {
  CircleAxis result;
  MeasuredAxis& axis = result.axis;
  const auto [low, high] = std::minmax_element(arc.turned_rad.begin(), arc.turned_rad.end());
  axis.span_rad = *high - *low;
  const CircleFit circle = fit_circle(arc.points_mm, {{.u_point_mm = arc.u_mm}});
  if (!circle.ok()) return refused(arc, axis, circle.status);
  axis.center_mm = circle.center_mm;
  axis.direction = circle.normal;
  axis.radius_mm = circle.radius_mm;
  axis.rms_mm = circle.rms_mm;
  axis.covariance = circle.covariance->topLeftCorner<6, 6>();
  axis.u_center_mm = largest_u(axis.covariance.topLeftCorner<3, 3>());
  axis.u_direction_rad = largest_u(axis.covariance.bottomRightCorner<3, 3>());
  if (!(axis.u_direction_rad <= largest_u_direction_rad)) {
    return refused(arc, axis, FitStatus::radius_unbounded);
  }
  if (circle.rms_mm > kBlunder_rad * circle.radius_mm + 5.0 * arc.u_mm) {
    result.status = CirclePointStatus::not_a_circle;
    result.detail =
        fmt::format("the points of joint {} are {:.3f} mm (rms) off a circle of {:.1f} mm radius",
                    arc.joint, circle.rms_mm, circle.radius_mm);
    return result;
  }
  const double forwards = std::abs(agreement(arc, axis, 1.0));
  const double backwards = std::abs(agreement(arc, axis, -1.0));
  if (backwards > forwards) axis.direction = -axis.direction;
  // For small deviations the mean is 1 - (their mean square) / 2.
  const double off_rad = std::sqrt(2.0 * std::max(0.0, 1.0 - std::max(forwards, backwards)));
  if (off_rad > kBlunder_rad + 5.0 * arc.u_mm / axis.radius_mm) {
    result.status = CirclePointStatus::encoder_disagrees;
    result.detail =
        fmt::format("the points of joint {} are {:.2f} deg (rms) from where its encoder says",
                    arc.joint, degrees_from_radians(off_rad));
  }
  return result;
}

Eigen::Vector3d tip_at_home(const JointArc& arc, const MeasuredAxis& axis) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < arc.points_mm.size(); ++k) {
    const Eigen::AngleAxisd back(-arc.turned_rad[k], axis.direction);
    sum += back * Eigen::Vector3d(arc.points_mm[k] - axis.center_mm);
  }
  return axis.center_mm + sum / static_cast<double>(arc.points_mm.size());
}

std::string_view explain(CirclePointStatus status) {
  switch (status) {
    case CirclePointStatus::found:
      return "found";
    case CirclePointStatus::joint_without_arc:
      return "a joint has no arc";
    case CirclePointStatus::other_joint_moved:
      return "another joint moved during an arc";
    case CirclePointStatus::not_a_circle:
      return "the points of a joint are on no circle";
    case CirclePointStatus::arc_too_short:
      return "an arc is too short to know its axis";
    case CirclePointStatus::tip_on_axis:
      return "the tip is on the axis of a joint, or too near, and draws no circle";
    case CirclePointStatus::encoder_disagrees:
      return "an arc and its encoder disagree";
    case CirclePointStatus::arcs_disagree:
      return "the arcs do not belong to one home posture";
    case CirclePointStatus::unlike_nominal:
      return "the axes are not those of the nominal arm";
  }
  return "unknown";
}

}  // namespace armcal
