// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/measured_point.h"

#include "armcal/arm/forward_kinematics.h"

namespace armcal {
namespace {

ArmModel with_tip_at(const ArmModel& arm, const Eigen::Vector3d& point_mm) {
  ArmModel moved = arm;
  moved.tip.a_mm = point_mm.x();
  moved.tip.b_mm = point_mm.y();
  moved.tip.d_mm = point_mm.z();
  return moved;
}

}  // namespace

Eigen::Vector3d tip_of(const ArmModel& arm) { return {arm.tip.a_mm, arm.tip.b_mm, arm.tip.d_mm}; }

bool is_of_tip(const TipColumn& column) {
  return column.kind == ParameterKind::tip_a || column.kind == ParameterKind::tip_b ||
         column.kind == ParameterKind::tip_d;
}

std::vector<TipColumn> columns_with_point(const Unknowns& unknowns) {
  std::vector<TipColumn> columns = unknowns.columns();
  const int last = unknowns.nominal().joint_count() - 1;
  for (const ParameterKind kind :
       {ParameterKind::tip_a, ParameterKind::tip_b, ParameterKind::tip_d}) {
    columns.push_back({kind, last, 0});
  }
  return columns;
}

MovingPoints moving_tips(const ArmModel& arm, const Eigen::MatrixXd& encoder_rad) {
  const ForwardKinematics kinematics(arm);
  TipLinearisation here;
  const Eigen::Index count = encoder_rad.cols();
  MovingPoints points{Eigen::Matrix3Xd(3, count), Eigen::MatrixXd(3 * count, encoder_rad.rows())};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto posture = encoder_rad.col(i);
    kinematics.linearise({posture.data(), static_cast<std::size_t>(posture.size())}, here);
    points.at_mm.col(i) = here.tip_mm;
    points.J_encoders.middleRows<3>(3 * i) = here.J_tip_encoder;
  }
  return points;
}

MeasuredPoint::MeasuredPoint(const ObservationGroup& group, const Eigen::MatrixXd& encoder_rad,
                             Unknowns& unknowns, std::vector<int>& nuisances)
    : postures_(encoder_rad), offset_mm_(group.offset_mm) {
  if (group.target.empty()) return;
  target_ = unknowns.add("target." + group.target, NuisanceKind::point);
  nuisances.push_back(*target_);
}

ArmModel MeasuredPoint::with_measured_tip(const ArmModel& arm, const Unknowns& unknowns,
                                          const Eigen::VectorXd& x) const {
  if (target_) return with_tip_at(arm, unknowns.point(x, *target_));
  const Eigen::Matrix3d turn = rotation_from_roll_pitch_yaw(arm.tip.roll_pitch_yaw_rad);
  return with_tip_at(arm, tip_of(arm) + turn * offset_mm_);
}

MovingPoints MeasuredPoint::moving(const ArmModel& arm, const Unknowns& unknowns,
                                   const Eigen::VectorXd& x,
                                   const Eigen::MatrixXd& encoder_rad) const {
  return moving_tips(with_measured_tip(arm, unknowns, x), encoder_rad);
}

void MeasuredPoint::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x,
                         Eigen::Index first, Eigen::Index count,
                         const TipRows::Target& target) const {
  if (!target_) {
    if (offset_mm_.isZero(0.0)) {
      at.tips.fill(postures_, first, count, target);
      return;
    }
    const TipRows shifted(with_measured_tip(at.arm, unknowns, x), unknowns.columns());
    shifted.fill(postures_, first, count, target);
    return;
  }
  // The target moves as the tip would; the arm's own tip does not count.
  const std::vector<TipColumn> columns = columns_with_point(unknowns);
  const TipRows tips(with_measured_tip(at.arm, unknowns, x), columns);
  tips.fill(postures_, first, count, target);
  if (target.rows == nullptr) return;
  for (std::size_t c = 0; c < unknowns.columns().size(); ++c) {
    if (!is_of_tip(columns[c])) continue;
    for (Eigen::Index k = 0; k < count; ++k) {
      for (Eigen::Index r = 0; r < 3; ++r) {
        target.rows[(target.rows_per_posture * k + r) * target.stride +
                    static_cast<Eigen::Index>(c)] = 0.0;
      }
    }
  }
}

Eigen::Matrix3Xd MeasuredPoint::start(const ArmAt& nominal, Unknowns& unknowns,
                                      Eigen::VectorXd& x) const {
  if (target_ && !unknowns[*target_].started) {
    unknowns.set_point(x, *target_, tip_of(nominal.arm) + offset_mm_);
    unknowns[*target_].started = true;
  }
  return all(nominal, unknowns, x);
}

Eigen::Matrix3Xd MeasuredPoint::all(const ArmAt& at, const Unknowns& unknowns,
                                    const Eigen::VectorXd& x) const {
  Eigen::Matrix3Xd points(3, postures_.count());
  fill(at, unknowns, x, 0, postures_.count(), {.tips = points.data()});
  return points;
}

}  // namespace armcal
