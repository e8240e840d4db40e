// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "armcal/identification/residuals/residual.h"

namespace armcal {

/// Place of the tip in the frame of the last joint.
[[nodiscard]] Eigen::Vector3d tip_of(const ArmModel& arm);
[[nodiscard]] bool is_of_tip(const TipColumn& column);
/// The columns of the arm's free parameters, then those of the point that moves with the last
/// joint.
[[nodiscard]] std::vector<TipColumn> columns_with_point(const Unknowns& unknowns);

/// Points of the arm at given postures and how they move with its encoders.
struct MovingPoints {
  Eigen::Matrix3Xd at_mm;      ///< base frame
  Eigen::MatrixXd J_encoders;  ///< rows: x y z of every point (per rad); columns: joints
};
[[nodiscard]] MovingPoints moving_tips(const ArmModel& arm, const Eigen::MatrixXd& encoder_rad);

/// The point of the arm that a group's readings are of: the tip, a point at a known offset from it,
/// or an unknown point of the last joint (a target), whose place is then the first nuisance of the
/// residual.
class MeasuredPoint {
 public:
  MeasuredPoint(const ObservationGroup& group, const Eigen::MatrixXd& encoder_rad,
                Unknowns& unknowns, std::vector<int>& nuisances);

  [[nodiscard]] const PosturePacks& postures() const { return postures_; }

  /// Points of postures first .. and, with rows, their derivatives: the arm's columns, then the
  /// target's.
  void fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x, Eigen::Index first,
            Eigen::Index count, const TipRows::Target& target) const;

  /// All points, base frame.
  [[nodiscard]] Eigen::Matrix3Xd all(const ArmAt& at, const Unknowns& unknowns,
                                     const Eigen::VectorXd& x) const;

  [[nodiscard]] MovingPoints moving(const ArmModel& arm, const Unknowns& unknowns,
                                    const Eigen::VectorXd& x,
                                    const Eigen::MatrixXd& encoder_rad) const;

  /// All points at the start; a target without a value starts at the nominal tip.
  [[nodiscard]] Eigen::Matrix3Xd start(const ArmAt& nominal, Unknowns& unknowns,
                                       Eigen::VectorXd& x) const;

  /// Number of columns before the residual's own nuisances.
  [[nodiscard]] Eigen::Index columns(const Unknowns& unknowns) const {
    return unknowns.arm_size() + (target_ ? 3 : 0);
  }

 private:
  // The arm with the measured point for its tip.
  [[nodiscard]] ArmModel with_measured_tip(const ArmModel& arm, const Unknowns& unknowns,
                                           const Eigen::VectorXd& x) const;

  PosturePacks postures_;
  Eigen::Vector3d offset_mm_;
  std::optional<int> target_;
};

}  // namespace armcal
