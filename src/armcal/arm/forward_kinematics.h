// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

/// The tip and how it moves, at one posture, all in base coordinates.
struct TipLinearisation {
  Eigen::Vector3d tip_mm;
  /// Rows: x y z (mm). Columns: ParameterTable order (per mm or per rad).
  Eigen::Matrix3Xd J_tip_parameters;
  /// Columns: encoder reading of each joint (per rad).
  Eigen::Matrix3Xd J_tip_encoder;
  /// Axis of each joint and a point on it, before the joint's own rotation.
  Eigen::Matrix3Xd joint_axes;
  Eigen::Matrix3Xd joint_origins_mm;
};

/// Where an arm's tip is. Prepared once per arm (sines and cosines of the twists), then cheap per
/// posture: no function but the first use of a TipLinearisation allocates. Const and safe to share
/// between threads.
///
/// theory/kinematics.md eq. (1)-(8). Encoder readings are rad, one per joint; a span of another
/// size is a bug of the caller and ends the program.
class ForwardKinematics {
 public:
  /// @throws std::invalid_argument naming every problem of a model that is not sound
  explicit ForwardKinematics(const ArmModel& arm);

  [[nodiscard]] int joint_count() const { return joint_count_; }

  [[nodiscard]] Eigen::Vector3d tip_in_base(std::span<const double> encoder_rad) const;

  /// Pose of the tip frame: position as above, orientation of the last joint times that of the tip.
  [[nodiscard]] RigidTransform base_from_tip(std::span<const double> encoder_rad) const;

  /// Tip with its derivatives: analytic, one sweep. `result` is a workspace: reuse it and nothing
  /// is allocated after its first use.
  void linearise(std::span<const double> encoder_rad, TipLinearisation& result) const;
  [[nodiscard]] TipLinearisation linearise(std::span<const double> encoder_rad) const;

 private:
  struct PreparedLink {
    double d, b, a, cos_alpha, sin_alpha, cos_beta, sin_beta;
    bool has_beta;
  };
  struct PreparedJoint {
    double zero, direction;
    bool has_harmonics;
  };
  struct Sweep;

  [[nodiscard]] double angle(std::size_t joint, double encoder_rad) const;
  [[nodiscard]] Sweep sweep_to_last_joint(std::span<const double> encoder_rad) const;

  int joint_count_;
  Eigen::Index parameter_count_;
  ArmModel arm_;
  std::array<PreparedJoint, kMaxJoints> joints_{};
  std::array<PreparedLink, kMaxJoints> links_{};
  Eigen::Matrix3d joint_from_tip_rotation_;
};

/// Tips of an arm. @param encoder_rad  a column for each
[[nodiscard]] std::vector<Eigen::Vector3d> tips_in_base(const ArmModel& arm,
                                                        const Eigen::MatrixXd& encoder_rad);

}  // namespace armcal
