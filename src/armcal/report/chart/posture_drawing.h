// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/report/chart/space_view.h"
#include "armcal/report/chart/svg.h"

namespace armcal {

/// An arm as it stands at a posture: origins and axes of its joints, and its tip, in the base
/// frame.
struct StandingArm {
  Eigen::Matrix3Xd origins_mm;
  Eigen::Matrix3Xd axes;
  Eigen::Vector3d tip_mm = Eigen::Vector3d::Zero();

  [[nodiscard]] int joint_count() const { return static_cast<int>(origins_mm.cols()); }
  /// Point 0 is the first origin, the last one the tip.
  [[nodiscard]] Eigen::Vector3d point(int index) const {
    return index < joint_count() ? Eigen::Vector3d(origins_mm.col(index)) : tip_mm;
  }
};
/// @return nothing for a posture of another number of joints, or one that is not finite
[[nodiscard]] std::optional<StandingArm> standing(const ArmModel& arm,
                                                  const Eigen::VectorXd& q_rad);

/// Something that is drawn before what is nearer to the eye.
struct PaintedPiece {
  double nearness = 0.0;
  std::string svg;
};

/// The pieces of an arm: pedestal from the ground, links as tapered strokes, joints as short
/// cylinders about their axes, the ball at the tip.
/// @param emphasised  a joint that is drawn in colour, from 0; -1: none
[[nodiscard]] std::vector<PaintedPiece> solid_pieces(const StandingArm& arm, const SpaceView& view,
                                                     double ground_mm, int emphasised = -1);

/// The same arm elsewhere, as a dashed line.
[[nodiscard]] std::string dashed_arm(const StandingArm& arm, const SpaceView& view);
/// Its shadow on the ground, below everything.
[[nodiscard]] std::string shadow(const StandingArm& arm, const SpaceView& view, double ground_mm);

/// The point of the ground, at this height along `up`, below a point.
[[nodiscard]] Eigen::Vector3d on_ground(const Eigen::Vector3d& point, const Eigen::Vector3d& up,
                                        double ground_mm);

}  // namespace armcal
