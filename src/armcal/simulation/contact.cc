// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/contact.h"

#include <fmt/format.h>

#include "armcal/arm/forward_kinematics.h"

namespace armcal {
namespace {

constexpr int kAttempts = 200;

// A wrist behind the surface that is touched would hold a stylus that passes through it.
bool stands_on_free_side(const ForwardKinematics& kinematics, const Eigen::VectorXd& posture,
                         const Feature& feature) {
  if (feature.outward.isZero()) return true;
  const TipLinearisation at =
      kinematics.linearise({posture.data(), static_cast<std::size_t>(posture.size())});
  const Eigen::Vector3d wrist = at.joint_origins_mm.rightCols<1>();
  return feature.outward.dot(wrist - feature.at_mm) > 0.0;
}

Circumstances now(const Laboratory& laboratory, const Feature& feature) {
  return {.time_s = laboratory.time_s(), .push = -feature.outward};
}

}  // namespace

TakenReading take_on(Laboratory& laboratory, const Feature& feature, const std::string& what) {
  const ForwardKinematics kinematics(laboratory.arm().truth());
  for (int i = 0; i < kAttempts; ++i) {
    const Eigen::VectorXd posture =
        laboratory.postures_with_tip_at(feature.at_mm, 1, what, now(laboratory, feature)).front();
    if (!stands_on_free_side(kinematics, posture, feature)) continue;
    return laboratory.take(posture, -feature.outward);
  }
  throw Impossible(fmt::format("{} at ({:.1f}, {:.1f}, {:.1f}) mm is reached from behind only",
                               what, feature.at_mm.x(), feature.at_mm.y(), feature.at_mm.z()));
}

bool is_within_reach(Laboratory& laboratory, const Feature& feature) {
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

void take_in_seat(Laboratory& laboratory, const Feature& seat, const std::string& what, int count,
                  double u_mm, ObservationGroup& group, Eigen::Index first) {
  for (Eigen::Index i = 0; i < count; ++i) {
    Feature held = seat;
    held.at_mm += laboratory.noise(u_mm);
    group.encoder_rad.col(first + i) = take_on(laboratory, held, what).encoder_rad;
  }
}

}  // namespace armcal
