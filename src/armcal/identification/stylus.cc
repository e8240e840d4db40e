// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/stylus.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

bool is_of_tip(ParameterKind kind) {
  return kind == ParameterKind::tip_a || kind == ParameterKind::tip_b ||
         kind == ParameterKind::tip_d;
}

// Covariance of the tip, from that of the free parameters.
Eigen::Matrix3d tip_block(const Calibration& calibration, int first) {
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < calibration.free.size(); ++i) {
    for (std::size_t j = 0; j < calibration.free.size(); ++j) {
      block(calibration.free[i] - first, calibration.free[j] - first) =
          calibration.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  return block;
}

void take_over(const CalibratedParameter& found, TipCoordinate& coordinate) {
  coordinate.value_mm = found.value;
  coordinate.u_mm = found.u;
  coordinate.determined = found.status == ParameterStatus::free;
}

void judge_change(StylusQualification& stylus) {
  Eigen::Vector3d change;
  for (std::size_t k = 0; k < 3; ++k) {
    change(static_cast<Eigen::Index>(k)) = stylus.tip[k].value_mm - stylus.tip[k].old_mm;
  }
  stylus.change_mm = change.norm();
  const Eigen::VectorXd variances = symmetric_eigenvalues(stylus.covariance_mm2);
  constexpr double kCoverageFactor = 2.0;
  stylus.U_mm = kCoverageFactor * std::sqrt(std::max(0.0, variances(2)));
  if (!stylus.undetermined().empty()) return;
  const Eigen::VectorXd weighed = shortest_solution(stylus.covariance_mm2, change);
  stylus.change_in_u = std::sqrt(std::max(0.0, change.dot(weighed)));
}

}  // namespace

std::vector<std::string> StylusQualification::undetermined() const {
  std::vector<std::string> names;
  for (const TipCoordinate& each : tip) {
    if (!each.determined) names.push_back(each.parameter);
  }
  return names;
}

Eigen::Vector3d swings_of_last_joint(const ArmModel& arm, const Eigen::MatrixXd& encoder_rad) {
  ArmModel plain = arm;
  plain.tip.roll_pitch_yaw_rad.setZero();
  const ForwardKinematics kinematics(plain);
  std::vector<Eigen::Matrix3d> turned;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < encoder_rad.cols(); ++i) {
    turned.push_back(kinematics.base_from_tip(as_span(encoder_rad.col(i))).rotation);
    sum += turned.back();
  }
  Eigen::Vector3d swings = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d mean = sum.col(axis) / static_cast<double>(turned.size());
    constexpr double kNoDirection = 1e-9;
    for (const Eigen::Matrix3d& each : turned) {
      const double angle =
          mean.norm() < kNoDirection
              ? std::numbers::pi
              : std::atan2(mean.cross(each.col(axis)).norm(), mean.dot(each.col(axis)));
      swings(axis) = std::max(swings(axis), angle);
    }
  }
  return swings;
}

StylusQualification qualify_stylus(const ArmModel& arm, const ObservationGroup& readings,
                                   const Monitor& monitor) {
  const ParameterTable table(arm);
  CalibrationOptions options;
  options.monitor = monitor;
  std::vector<int> of_tip;  // a, b, d: neighbours in the table
  for (int i = 0; i < table.size(); ++i) {
    if (is_of_tip(table[i].kind)) {
      of_tip.push_back(i);
    } else {
      options.hold.push_back(table[i].name);
    }
  }
  StylusQualification stylus;
  stylus.calibration = calibrate(arm, {&readings, 1}, options);
  const bool found = stylus.calibration.ok();
  const Eigen::Vector3d swings = swings_of_last_joint(arm, readings.encoder_rad);
  for (std::size_t k = 0; k < stylus.tip.size(); ++k) {
    const Parameter& parameter = table[of_tip[k]];
    stylus.tip[k].parameter = parameter.name;
    stylus.tip[k].old_mm = parameter.nominal;
    stylus.tip[k].swing_rad = swings(static_cast<Eigen::Index>(k));
    if (found)
      take_over(stylus.calibration.parameters.at(static_cast<std::size_t>(of_tip[k])),
                stylus.tip[k]);
  }
  if (found) {
    stylus.covariance_mm2 = tip_block(stylus.calibration, of_tip.front());
    judge_change(stylus);
  }
  return stylus;
}

}  // namespace armcal
