// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/clearance.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/simulation/arm_state.h"
#include "armcal/simulation/error_sources.h"

namespace armcal {

/// What a reading is taken under, beside the posture.
struct Circumstances {
  double time_s = 0.0;  ///< since the arm was switched on
  /// Direction in which the probe pushes against what it touches, base frame, of unit length; zero
  /// where nothing is touched (a reflector, a locked arm).
  Eigen::Vector3d push = Eigen::Vector3d::Zero();
  /// Of the foot at this reading: rotation about the origin of the first joint, then translation,
  /// base frame. Drawn with `drawn_movement`.
  RigidTransform base_movement;
};

/// An arm whose truth is known: its drawing, the geometry that it really has, and everything else
/// that moves its tip. Const and safe to share between threads; whoever takes readings brings the
/// random numbers. theory/virtual_arm.md
///
/// Every source of error draws from its own stream: one more changes nothing about the others, and
/// twice the size is twice the same errors.
class VirtualArm {
 public:
  /// Draws the errors. The same seed gives the same arm.
  /// @throws std::invalid_argument where the drawing or the sag of its links is not sound
  VirtualArm(ArmModel nominal, const ErrorSources& errors, std::uint64_t seed,
             Surroundings surroundings = {});
  /// An arm of given geometry: `errors.geometry` is not used, eccentric scales are added.
  VirtualArm(ArmModel nominal, ArmModel truth, const ErrorSources& errors, std::uint64_t seed,
             Surroundings surroundings = {});

  [[nodiscard]] const ArmModel& nominal() const { return nominal_; }
  /// The geometry (zeros, links, tip, eccentric scales) that a perfect calibration would find if
  /// nothing else were wrong with the arm.
  [[nodiscard]] const ArmModel& truth() const { return truth_; }
  [[nodiscard]] const ErrorSources& errors() const { return errors_; }
  [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }

  /// Where the tip really is while the encoders stand at these angles (before their own noise),
  /// base frame. Without errors that of ForwardKinematics of the truth, to rounding.
  /// theory/virtual_arm.md eq. (1)
  [[nodiscard]] Eigen::Vector3d tip(const Eigen::VectorXd& encoder_rad,
                                    const Circumstances& circumstances = {}) const;

  /// How the last joint is turned there, base frame: what a target on it shows beside its place.
  [[nodiscard]] Eigen::Matrix3d base_from_last_joint(const Eigen::VectorXd& encoder_rad,
                                                     const Circumstances& circumstances = {}) const;

  /// What the encoders show there.
  [[nodiscard]] Eigen::VectorXd shown(const Eigen::VectorXd& encoder_rad,
                                      RandomStream& random) const;

  /// Why the arm cannot stand so: a joint limit, its own column, the bench. Nothing where it can.
  [[nodiscard]] std::optional<std::string> obstacle(const Eigen::VectorXd& encoder_rad) const;

  /// Angles near `start_rad` at which the true tip is on the point, to 1e-9 mm, inside all joint
  /// limits; nothing where the search does not arrive or ends in an obstacle. A start beyond a
  /// limit is first turned by whole turns, or moved to the limit.
  [[nodiscard]] std::optional<Eigen::VectorXd> posture_with_tip_at(
      const Eigen::Vector3d& point_mm, const Eigen::VectorXd& start_rad,
      const Circumstances& circumstances = {}) const;

 private:
  // What was drawn of the sources that are on; empty where a source is off.
  struct Drawn {
    std::vector<RunOutOfJoint> run_out;
    std::vector<LinkBody> bodies;
    std::vector<double> growth;
    DrawnDrift drift;
  };
  [[nodiscard]] static Drawn drawn(const ArmModel& truth, const ErrorSources& errors,
                                   std::uint64_t seed);
  [[nodiscard]] ArmState state(const Eigen::VectorXd& encoder_rad,
                               const Circumstances& circumstances) const;

  ArmModel nominal_;
  ArmModel truth_;
  ErrorSources errors_;
  Surroundings surroundings_;
  Drawn drawn_;
  ForwardKinematics kinematics_;  // of the truth
};

}  // namespace armcal
