// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "armcal/identification/calibration.h"

namespace armcal {

/// One coordinate of a tip.
struct TipCoordinate {
  std::string parameter;  ///< a7
  double old_mm = 0.0;
  double value_mm = 0.0;
  double u_mm = 0.0;
  bool determined = false;
  /// How far its direction swings: the largest angle, over the postures, from the mean direction.
  /// Without swing the readings cannot tell this coordinate from a shift of the seat.
  double swing_rad = 0.0;

  [[nodiscard]] double change_in_u() const { return u_mm > 0.0 ? (value_mm - old_mm) / u_mm : 0.0; }
};

/// A stylus as qualified: the tip of an arm, everything else of it held.
struct StylusQualification {
  Calibration calibration;
  std::array<TipCoordinate, 3> tip;  ///< along x, y, z of the last joint: a, b, d
  Eigen::Matrix3d covariance_mm2 = Eigen::Matrix3d::Zero();  ///< of the tip; rows of what is not
                                                             ///< determined are 0
  double U_mm = 0.0;  ///< expanded uncertainty, k = 2, of the tip in its worst direction
  double change_mm = 0.0;
  /// Length of the change in its own uncertainty, sqrt(change^T covariance^-1 change); 95 % of
  /// styluses that are the old one stay below 2.8. 0 where not all is determined.
  double change_in_u = 0.0;

  /// Names of the coordinates that the readings do not determine.
  [[nodiscard]] std::vector<std::string> undetermined() const;
};

/// theory/identification.md with all parameters but the tip held.
/// @param readings  kind fixed_point or sphere
[[nodiscard]] StylusQualification qualify_stylus(const ArmModel& arm,
                                                 const ObservationGroup& readings,
                                                 const Monitor& monitor = {});

/// Largest angle of each column direction of a turning frame from its mean over the postures, rad;
/// pi where there is no mean direction. @param postures  encoder readings, a column each
[[nodiscard]] Eigen::Vector3d swings_of_last_joint(const ArmModel& arm,
                                                   const Eigen::MatrixXd& encoder_rad);

}  // namespace armcal
