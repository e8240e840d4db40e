// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/encoder_share.h"

#include <cmath>
#include <span>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// Variance of the distance per variance of one encoder reading.
double of_half_turn(const ForwardKinematics& kinematics, const SymmetricReading& reading,
                    const EncoderRepeats& repeats) {
  const TipLinearisation before = kinematics.linearise(as_span(reading.posture_rad));
  const TipLinearisation after = kinematics.linearise(as_span(reading.posture_end_rad));
  const Eigen::Vector3d direction = (before.tip_mm - after.tip_mm).stableNormalized();
  const Eigen::VectorXd at_posture = before.J_tip_encoder.transpose() * direction;
  const Eigen::VectorXd at_end = -after.J_tip_encoder.transpose() * direction;
  if (repeats.at_end == 0) return (at_posture + at_end).squaredNorm() / repeats.at_posture;
  return at_posture.squaredNorm() / repeats.at_posture + at_end.squaredNorm() / repeats.at_end;
}

// Only joints behind the axis change the radius about it.
double of_circle(const ForwardKinematics& kinematics, const SymmetricReading& reading,
                 const EncoderRepeats& repeats) {
  const TipLinearisation at = kinematics.linearise(as_span(reading.posture_rad));
  const Eigen::Index column = reading.joint - 1;
  const Eigen::Vector3d axis = at.joint_axes.col(column);
  const Eigen::Vector3d lever = at.tip_mm - at.joint_origins_mm.col(column);
  const Eigen::Vector3d outwards = (lever - axis * axis.dot(lever)).stableNormalized();
  const Eigen::VectorXd all = at.J_tip_encoder.transpose() * outwards;
  return all.tail(all.size() - reading.joint).squaredNorm() / repeats.at_posture;
}

}  // namespace

double u_from_encoders(const ArmModel& arm, const SymmetricReading& reading, double u_encoder_rad,
                       const EncoderRepeats& repeats) {
  ARMCAL_INVARIANT(repeats.at_posture >= 1 && repeats.at_end >= 0);
  if (u_encoder_rad <= 0.0) return 0.0;
  const ForwardKinematics kinematics(arm);
  switch (reading.kind) {
    case SymmetricKind::reversal:
      return u_encoder_rad * std::sqrt(of_half_turn(kinematics, reading, repeats));
    case SymmetricKind::circle_radius:
      return u_encoder_rad * std::sqrt(of_circle(kinematics, reading, repeats));
    case SymmetricKind::zero_search:
      break;
  }
  return 0.0;
}

}  // namespace armcal
