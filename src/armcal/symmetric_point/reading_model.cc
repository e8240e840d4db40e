// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/reading_model.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "armcal/arm/encoder.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/core/invariant.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/symmetric_point/radius_wave.h"

namespace armcal {
namespace {

// A distance or radius below this share of the reach is rounding about zero: it has no direction.
constexpr double kNoDistance = 1e-12;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

ReadingPrediction without_gradient(double value, const ArmModel& arm) {
  return {value, Eigen::VectorXd::Constant(ParameterTable(arm).size(), kNotANumber)};
}

ReadingPrediction reversal(const ForwardKinematics& kinematics, const ArmModel& arm,
                           const SymmetricReading& reading) {
  const TipLinearisation before = kinematics.linearise(as_span(reading.posture_rad));
  const TipLinearisation after = kinematics.linearise(as_span(reading.posture_end_rad));
  const Eigen::Vector3d step = before.tip_mm - after.tip_mm;
  const double distance = step.norm();
  if (!(distance > kNoDistance * reach_mm(arm))) return without_gradient(0.0, arm);
  return {distance,
          (before.J_tip_parameters - after.J_tip_parameters).transpose() * (step / distance)};
}

// Squared radius of the tip about a joint's axis and its gradient. What lies before the axis
// carries tip and axis together, so only parameters behind it count.
ReadingPrediction squared_radius(const ForwardKinematics& kinematics, const ParameterTable& table,
                                 std::span<const double> posture, int joint) {
  const TipLinearisation at = kinematics.linearise(posture);
  const Eigen::Index column = joint - 1;
  const Eigen::Vector3d axis = at.joint_axes.col(column);
  const Eigen::Vector3d lever = at.tip_mm - at.joint_origins_mm.col(column);
  const Eigen::Vector3d radial = lever - axis * axis.dot(lever);
  ReadingPrediction prediction{radial.squaredNorm(),
                               2.0 * at.J_tip_parameters.transpose() * radial};
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].joint <= joint) prediction.gradient(i) = 0.0;
  }
  return prediction;
}

ReadingPrediction circle_radius(const ForwardKinematics& kinematics, const ParameterTable& table,
                                const ArmModel& arm, const SymmetricReading& reading) {
  const ReadingPrediction squared =
      squared_radius(kinematics, table, as_span(reading.posture_rad), reading.joint);
  const double radius = std::sqrt(squared.value);
  if (!(radius > kNoDistance * reach_mm(arm))) return without_gradient(0.0, arm);
  return {radius, squared.gradient / (2.0 * radius)};
}

// The wave of the squared radius about the swept axis as the searched joint turns, and the gradient
// of each coefficient: the same combinations of five values and of their gradients.
struct WaveWithGradients {
  RadiusWave wave = RadiusWave::Zero();
  Eigen::Matrix<double, Eigen::Dynamic, kWaveSamples> gradients;  // rows: parameters
};

WaveWithGradients radius_wave(const ForwardKinematics& kinematics, const ParameterTable& table,
                              const ArmModel& arm, const SymmetricReading& reading) {
  const Joint& joint = arm.joints[static_cast<std::size_t>(reading.joint - 1)];
  Eigen::VectorXd posture = reading.posture_rad;
  double& encoder = posture(reading.joint - 1);
  WaveWithGradients result;
  result.gradients.setZero(table.size(), kWaveSamples);
  for (int k = 0; k < kWaveSamples; ++k) {
    const double t = wave_sample(k);
    encoder = encoder_at_joint_angle(joint, t, t / joint.direction - joint.zero_rad);
    const ReadingPrediction r2 = squared_radius(kinematics, table, as_span(posture), reading.sweep);
    result.wave += r2.value * wave_weights(k);
    result.gradients += r2.gradient * wave_weights(k).transpose();
  }
  return result;
}

// The parameters of the encoder of the searched joint turn angle into reading; with the angle fixed
// they do not move the tip.
bool belongs_to_encoder(const Parameter& parameter, int joint) {
  return parameter.joint == joint &&
         (parameter.kind == ParameterKind::zero || parameter.kind == ParameterKind::cosine ||
          parameter.kind == ParameterKind::sine);
}

ReadingPrediction zero_search(const ForwardKinematics& kinematics, const ParameterTable& table,
                              const ArmModel& arm, const SymmetricReading& reading) {
  const Joint& joint = arm.joints[static_cast<std::size_t>(reading.joint - 1)];
  const double start = reading.reduced ? reading.value : reading.posture_rad(reading.joint - 1);
  const WaveWithGradients at = radius_wave(kinematics, table, arm, reading);
  const auto extremum = extremum_near(at.wave, joint_angle(joint, start));
  if (!extremum) return without_gradient(kNotANumber, arm);

  const double t = *extremum;
  const double encoder = encoder_at_joint_angle(joint, t, start);
  const double slope = joint_angle_slope(joint, encoder);
  ReadingPrediction prediction{encoder,
                               at.gradients * wave_slope(t) / (-at.wave.dot(wave_bend(t)) * slope)};
  for (int i = 0; i < table.size(); ++i) {
    const Parameter& parameter = table[i];
    if (!belongs_to_encoder(parameter, reading.joint)) continue;
    double by_parameter = joint.direction;
    if (parameter.kind == ParameterKind::cosine) {
      by_parameter = std::cos(parameter.harmonic * encoder);
    } else if (parameter.kind == ParameterKind::sine) {
      by_parameter = std::sin(parameter.harmonic * encoder);
    }
    prediction.gradient(i) = -by_parameter / slope;
  }
  return prediction;
}

}  // namespace

ReadingPrediction predict(const ArmModel& arm, const SymmetricReading& reading) {
  ARMCAL_INVARIANT(reading.joint >= 1 && reading.joint <= arm.joint_count());
  ARMCAL_INVARIANT(reading.posture_rad.size() == arm.joint_count());
  const ForwardKinematics kinematics(arm);
  ReadingPrediction prediction;
  switch (reading.kind) {
    case SymmetricKind::reversal:
      prediction = reversal(kinematics, arm, reading);
      break;
    case SymmetricKind::circle_radius:
      prediction = circle_radius(kinematics, ParameterTable(arm), arm, reading);
      break;
    case SymmetricKind::zero_search:
      prediction = zero_search(kinematics, ParameterTable(arm), arm, reading);
      break;
  }
  return prediction;
}

}  // namespace armcal
