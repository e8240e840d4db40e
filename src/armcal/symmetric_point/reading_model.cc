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

namespace armcal {
namespace {

std::span<const double> as_span(const Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

// A distance or radius below this share of the reach is rounding about zero: it has no direction.
constexpr double kNoDistance = 1e-12;

ReadingPrediction reversal(const ForwardKinematics& kinematics, const ArmModel& arm,
                           const SymmetricReading& reading) {
  const TipLinearisation before = kinematics.linearise(as_span(reading.posture_rad));
  const TipLinearisation after = kinematics.linearise(as_span(reading.posture_end_rad));
  const Eigen::Vector3d step = before.tip_mm - after.tip_mm;
  const double distance = step.norm();
  if (!(distance > kNoDistance * reach_mm(arm)))
    return {std::numeric_limits<double>::quiet_NaN(), {}};
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
  if (!(radius > kNoDistance * reach_mm(arm)))
    return {std::numeric_limits<double>::quiet_NaN(), {}};
  return {radius, squared.gradient / (2.0 * radius)};
}

// As joint k turns, the squared radius about a lower axis is exactly
//   c0 + c1 cos(t) + s1 sin(t) + c2 cos(2 t) + s2 sin(2 t),   t the angle of the joint,
// so five values determine it, and the same five combinations of their gradients are the gradients
// of the coefficients. Only the four that matter for an extremum are kept.
struct RadiusWave {
  double c1 = 0.0, s1 = 0.0, c2 = 0.0, s2 = 0.0;
  Eigen::VectorXd by_c1, by_s1, by_c2, by_s2;

  [[nodiscard]] double slope(double t) const {
    return -c1 * std::sin(t) + s1 * std::cos(t) +
           2.0 * (-c2 * std::sin(2 * t) + s2 * std::cos(2 * t));
  }
  [[nodiscard]] double bend(double t) const {
    return -c1 * std::cos(t) - s1 * std::sin(t) -
           4.0 * (c2 * std::cos(2 * t) + s2 * std::sin(2 * t));
  }
  [[nodiscard]] Eigen::VectorXd slope_gradient(double t) const {
    return -by_c1 * std::sin(t) + by_s1 * std::cos(t) +
           2.0 * (-by_c2 * std::sin(2 * t) + by_s2 * std::cos(2 * t));
  }
};

RadiusWave radius_wave(const ForwardKinematics& kinematics, const ParameterTable& table,
                       const ArmModel& arm, const SymmetricReading& reading) {
  constexpr int kSamples = 5;
  const Joint& joint = arm.joints[static_cast<std::size_t>(reading.joint - 1)];
  Eigen::VectorXd posture = reading.posture_rad;
  double& encoder = posture(reading.joint - 1);
  RadiusWave wave;
  wave.by_c1 = wave.by_s1 = wave.by_c2 = wave.by_s2 = Eigen::VectorXd::Zero(table.size());
  for (int i = 0; i < kSamples; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kSamples;
    encoder = encoder_at_joint_angle(joint, t, t / joint.direction - joint.zero_rad);
    const ReadingPrediction r2 = squared_radius(kinematics, table, as_span(posture), reading.sweep);
    const double weight = 2.0 / kSamples;
    const auto add = [&](double factor, double& c, Eigen::VectorXd& by_c) {
      c += weight * factor * r2.value;
      by_c += weight * factor * r2.gradient;
    };
    add(std::cos(t), wave.c1, wave.by_c1);
    add(std::sin(t), wave.s1, wave.by_s1);
    add(std::cos(2 * t), wave.c2, wave.by_c2);
    add(std::sin(2 * t), wave.s2, wave.by_s2);
  }
  return wave;
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
  const RadiusWave wave = radius_wave(kinematics, table, arm, reading);
  double t = joint_angle(joint, start);
  ReadingPrediction none{std::numeric_limits<double>::quiet_NaN(), {}};
  const double size = std::hypot(wave.c1, wave.s1) + 4.0 * std::hypot(wave.c2, wave.s2);
  if (!(size > 0.0)) return none;
  for (int i = 0; i < 50; ++i) {
    const double bend = wave.bend(t);
    // Damped where the wave is nearly straight, so that the nearest extremum is found and not a far
    // one.
    const double step = -wave.slope(t) / std::copysign(std::max(std::abs(bend), 0.05 * size), bend);
    t += step;
    if (std::abs(step) < 1e-15) break;
  }
  if (std::abs(wave.bend(t)) < 1e-9 * size || std::abs(wave.slope(t)) > 1e-9 * size) return none;

  const double encoder = encoder_at_joint_angle(joint, t, start);
  const double slope = joint_angle_slope(joint, encoder);
  ReadingPrediction prediction{encoder, wave.slope_gradient(t) / (-wave.bend(t) * slope)};
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
  const ParameterTable table(arm);
  ReadingPrediction prediction;
  switch (reading.kind) {
    case SymmetricKind::reversal:
      prediction = reversal(kinematics, arm, reading);
      break;
    case SymmetricKind::circle_radius:
      prediction = circle_radius(kinematics, table, arm, reading);
      break;
    case SymmetricKind::zero_search:
      prediction = zero_search(kinematics, table, arm, reading);
      break;
  }
  if (prediction.gradient.size() == 0) {
    prediction.gradient = Eigen::VectorXd::Constant(table.size(), prediction.value);
  }
  return prediction;
}

}  // namespace armcal
