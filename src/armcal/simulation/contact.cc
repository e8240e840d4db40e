// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/contact.h"

#include <fmt/format.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

constexpr int kContactAttempts = 200;

// A wrist behind the surface that is touched would hold a stylus that passes through it.
bool stands_on_free_side(const ForwardKinematics& kinematics, const Eigen::VectorXd& posture,
                         const Feature& feature) {
  if (feature.outward.isZero()) return true;
  const TipLinearisation at = kinematics.linearise(as_span(posture));
  const Eigen::Vector3d wrist = at.joint_origins_mm.rightCols<1>();
  return feature.outward.dot(wrist - feature.at_mm) > 0.0;
}

Circumstances now(const Laboratory& laboratory, const Feature& feature) {
  return {.time_s = laboratory.time_s(), .push = -feature.outward};
}

}  // namespace

TakenReading take_on(Laboratory& laboratory, const Feature& feature, const std::string& what) {
  const ForwardKinematics kinematics(laboratory.arm().truth());
  for (int i = 0; i < kContactAttempts; ++i) {
    const Eigen::VectorXd posture =
        laboratory.postures_with_tip_at(feature.at_mm, 1, what, now(laboratory, feature)).front();
    if (!stands_on_free_side(kinematics, posture, feature)) continue;
    return laboratory.take_with_tip_at(feature.at_mm, posture, what, -feature.outward);
  }
  throw Impossible(fmt::format("{} at ({:.1f}, {:.1f}, {:.1f}) mm is reached from behind only",
                               what, feature.at_mm.x(), feature.at_mm.y(), feature.at_mm.z()));
}

bool is_beyond_reach(const VirtualArm& arm, const Eigen::Vector3d& point_mm) {
  const Eigen::Vector3d shoulder_mm = arm.truth().base_from_first_joint.translation_mm;
  return (point_mm - shoulder_mm).norm() > reach_mm(arm.truth());
}

bool is_within_reach(Laboratory& laboratory, const Feature& feature) {
  if (is_beyond_reach(laboratory.arm(), feature.at_mm)) return false;
  const ForwardKinematics kinematics(laboratory.arm().truth());
  // A stop or a column leaves one start in ten or so; a point that twenty miss is given up.
  constexpr int kMost = 60;
  constexpr int kMostInVain = 20;
  constexpr int kEnough = 2;
  int reached = 0;
  for (int i = 0; i < kMost && reached < kEnough; ++i) {
    if (i == kMostInVain && reached == 0) return false;
    const auto posture = laboratory.arm().posture_with_tip_at(
        feature.at_mm, laboratory.free_posture(), now(laboratory, feature));
    reached += posture && stands_on_free_side(kinematics, *posture, feature);
  }
  return reached == kEnough;
}

Eigen::MatrixXd take_in_seat(Laboratory& laboratory, const Feature& seat, const std::string& what,
                             int count, double u_mm) {
  const auto postures =
      laboratory.postures_with_tip_at(seat.at_mm, count, what, now(laboratory, seat));
  Eigen::MatrixXd encoder_rad(laboratory.arm().truth().joint_count(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d held_mm = seat.at_mm + laboratory.noise(u_mm);
    encoder_rad.col(i) =
        laboratory.take_with_tip_at(held_mm, postures[static_cast<std::size_t>(i)], what)
            .encoder_rad;
  }
  return encoder_rad;
}

}  // namespace armcal
