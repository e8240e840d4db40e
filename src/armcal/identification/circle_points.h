// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/rigid_transform.h"
#include "armcal/identification/circle_axis.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

struct CirclePointOptions {
  /// How far a joint may be off its home reading while another turns: 2e-4 rad are 0.2 mm at 1 m.
  double locked_rad = 2e-4;
  /// An axis that is known no better is refused.
  double largest_u_direction_rad = 2e-3;
  /// From the tip at home that one arc gives to that of all.
  double largest_disagreement_mm = 1.0;
};

struct CirclePointAnalysis {
  CirclePointStatus status = CirclePointStatus::joint_without_arc;
  std::string detail;
  /// Of the joints in their order, in the home posture; without result: as far as known.
  std::vector<MeasuredAxis> axes;
  Eigen::VectorXd home_rad;                                  ///< encoder readings
  Eigen::Vector3d tip_at_home_mm = Eigen::Vector3d::Zero();  ///< reference frame
  ArmModel arm;
  RigidTransform reference_from_base;
  std::vector<int> reversed;  ///< joints, from 1, that count against the nominal arm
  double rms_mm = 0.0;        ///< of the measured points off the tips of the arm found

  [[nodiscard]] bool ok() const { return status == CirclePointStatus::found; }
};

/// Circle-point analysis: while one joint after the other turns alone from a home posture, a
/// reference machine follows the tip; the axis of each circle is the axis of the joint, the angle
/// of the points on it against the encoder gives counting direction and zero, and the axes with the
/// tip at home are the arm. Early and plain: no start values, no iteration over the arm. Its price
/// is that one posture is all it sees, and that an axis is the better known the longer its arc and
/// the farther the tip.
///
/// With a laser tracker: A. Vorotnikov et al., 26th DAAAM Symposium 2016, 897-904,
/// doi:10.2507/26th.daaam.proceedings.125; step by step: the manual of SScanSS-2, "Circle Point
/// Analysis"; the textbook of the field is B. W. Mooring, Z. S. Roth, M. R. Driels, Fundamentals of
/// Manipulator Calibration, Wiley 1991. None was followed to the letter: here circles are fitted by
/// orthogonal distances, every point helps to place the tip at home (turned back about its axis),
/// and the arm is written in the parameters of the nominal one by `arm_from_axes`; encoder
/// harmonics and what axes cannot tell stay nominal.
///
/// @param arcs  kind reference_points, one set-up, `joint` naming the joint that turns in each row;
///              home is where a joint stands while others turn. Rows that are held out do not count
/// @throws std::invalid_argument where the group is not of that kind or not of this arm
[[nodiscard]] CirclePointAnalysis analyse_circle_points(const ArmModel& nominal,
                                                        const ObservationGroup& arcs,
                                                        const CirclePointOptions& options = {});

}  // namespace armcal
