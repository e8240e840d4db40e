// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/reference_poses.h"

#include <array>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/geometry/registration.h"
#include "armcal/identification/residuals/frame_start.h"
#include "armcal/identification/residuals/measured_point.h"

namespace armcal {
namespace {

// The three points of the target, in its own frame.
Eigen::Vector3d point_in_target(int k, double lever_mm) {
  if (k == 0) return Eigen::Vector3d::Zero();
  return lever_mm * Eigen::Vector3d::Unit(k - 1);
}

}  // namespace

ReferencePosesResidual::ReferencePosesResidual(const ObservationGroup& group, std::vector<int> rows,
                                               Unknowns& unknowns)
    : Residual(group, std::move(rows)), postures_(encoders(group.encoder_rad)) {
  if (!group.target.empty()) {
    target_ = unknowns.add("target." + group.target, NuisanceKind::point);
    nuisances_.push_back(*target_);
  }
  const std::string& name = group.target.empty() ? group.name : group.target;
  rotation_ = unknowns.add("target." + name, NuisanceKind::rotation);
  setup_ =
      unknowns.add("setup." + group.place[static_cast<std::size_t>(row(0))], NuisanceKind::frame);
  nuisances_.push_back(rotation_);
  nuisances_.push_back(setup_);
}

Eigen::Vector3d ReferencePosesResidual::origin(const ArmModel& arm, const Unknowns& unknowns,
                                               const Eigen::VectorXd& x) const {
  return target_ ? unknowns.point(x, *target_) : tip_of(arm);
}

std::optional<std::string> ReferencePosesResidual::start(const ArmAt& nominal, Unknowns& unknowns,
                                                         Eigen::VectorXd& x) const {
  if (target_ && !unknowns[*target_].started) {
    unknowns.set_point(x, *target_, tip_of(nominal.arm));
    unknowns[*target_].started = true;
  }
  // The set-up from the origins alone; then the turn of the target on the last joint, from the mean
  // over all poses.
  ArmModel arm = nominal.arm;
  const Eigen::Vector3d at = origin(nominal.arm, unknowns, x);
  arm.tip = {at.x(), at.y(), at.z(), Eigen::Vector3d::Zero()};
  const ForwardKinematics kinematics(arm);
  Eigen::Matrix3Xd tips(3, count());
  Eigen::Matrix3Xd origins(3, count());
  std::vector<Eigen::Matrix3d> last_joint;
  for (Eigen::Index i = 0; i < count(); ++i) {
    const auto posture = group().encoder_rad.col(row(i));
    const RigidTransform pose =
        kinematics.base_from_tip({posture.data(), static_cast<std::size_t>(posture.size())});
    tips.col(i) = pose.translation_mm;
    last_joint.push_back(pose.rotation);
    origins.col(i) = group().reference_mm.col(row(i));
  }
  if (auto problem = start_frame(tips, origins, setup_, unknowns, x)) return problem;
  if (unknowns[rotation_].started) return std::nullopt;
  const Eigen::Matrix3d reference_from_base = unknowns.frame(x, setup_).rotation;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < count(); ++i) {
    sum += (reference_from_base * last_joint[static_cast<std::size_t>(i)]).transpose() *
           group().orientation[static_cast<std::size_t>(row(i))];
  }
  unknowns.set_rotation(x, rotation_, nearest_rotation(sum));
  unknowns[rotation_].started = true;
  return std::nullopt;
}

void ReferencePosesResidual::fill(const ArmAt& at, const Unknowns& unknowns,
                                  const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index count,
                                  const BlockRows& rows) const {
  constexpr Eigen::Index kRows = 9;
  const RigidTransform T = unknowns.frame(x, setup_);
  const Eigen::Matrix3d back = T.rotation.transpose();
  const Eigen::Vector3d pivot = unknowns[setup_].pivot_mm;
  const Eigen::Matrix3d turn = unknowns.rotation(x, rotation_);
  const Eigen::Index by_point =
      unknowns.arm_size();  // first of three columns: by the point on the last joint
  const Eigen::Index by_turn = by_point + (target_ ? 3 : 0);
  const Eigen::Index by_setup = by_turn + 3;
  const std::vector<TipColumn> columns = columns_with_point(unknowns);
  std::array<double, 3 * kObservationsPerBlock> tips;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d lever = turn * point_in_target(k, group().lever_mm);
    const Eigen::Vector3d on_joint = origin(at.arm, unknowns, x) + lever;
    ArmModel arm = at.arm;
    arm.tip = {on_joint.x(), on_joint.y(), on_joint.z(), Eigen::Vector3d::Zero()};
    double* const data = rows.row(3 * k);
    TipRows(arm, columns).fill(postures_, first, count, {tips.data(), data, rows.stride, kRows});
    const Eigen::Matrix3d turned = -skew(lever);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto place = static_cast<std::size_t>(row(first + i));
      const Eigen::Vector3d in_reference =
          T * Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(tips.data() + 3 * i));
      const Eigen::Vector3d measured =
          group().reference_mm.col(row(first + i)) +
          group().orientation[place] * point_in_target(k, group().lever_mm);
      const Eigen::Vector3d r = back * (in_reference - measured);
      const Eigen::Matrix3d J_setup = -(back * skew(in_reference - pivot));
      for (Eigen::Index c = 0; c < 3; ++c) {
        double* row = rows.row(kRows * i + 3 * k + c);
        const Eigen::RowVector3d J_point(row[by_point], row[by_point + 1], row[by_point + 2]);
        const Eigen::RowVector3d J_turn = J_point * turned;
        for (Eigen::Index j = 0; j < 3; ++j) {
          row[by_turn + j] = J_turn(j);
          row[by_setup + j] = J_setup(c, j);
          row[by_setup + 3 + j] = back(c, j);
        }
        row[rows.columns] = r(c);
        if (!target_) continue;
        for (std::size_t column = 0; column < unknowns.columns().size(); ++column) {
          if (is_of_tip(columns[column])) row[column] = 0.0;
        }
      }
    }
  }
}

ObservedPlaces ReferencePosesResidual::places(const ArmAt& at, const Unknowns& unknowns,
                                              const Eigen::VectorXd& x) const {
  ArmModel arm = at.arm;
  const Eigen::Vector3d on_joint = origin(arm, unknowns, x);
  arm.tip = {on_joint.x(), on_joint.y(), on_joint.z(), Eigen::Vector3d::Zero()};
  return {all_tips(TipRows(arm, {}), postures_), {}};
}

Eigen::MatrixXd ReferencePosesResidual::J_residual_encoders(const ArmModel& arm,
                                                            const Unknowns& unknowns,
                                                            const Eigen::VectorXd& x) const {
  const Eigen::MatrixXd encoder_rad = encoders(group().encoder_rad);
  const Eigen::Matrix3d turn = unknowns.rotation(x, rotation_);
  Eigen::MatrixXd J(9 * count(), encoder_rad.rows());
  for (int k = 0; k < 3; ++k) {
    ArmModel at_point = arm;
    const Eigen::Vector3d on_joint =
        origin(arm, unknowns, x) + turn * point_in_target(k, group().lever_mm);
    at_point.tip = {on_joint.x(), on_joint.y(), on_joint.z(), Eigen::Vector3d::Zero()};
    const MovingPoints points = moving_tips(at_point, encoder_rad);
    for (Eigen::Index i = 0; i < count(); ++i) {
      J.middleRows<3>(9 * i + 3 * k) = points.J_encoders.middleRows<3>(3 * i);
    }
  }
  return J;
}

}  // namespace armcal
