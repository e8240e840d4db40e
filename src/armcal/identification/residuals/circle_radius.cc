// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/circle_radius.h"

#include "armcal/arm/forward_kinematics.h"

namespace armcal {
namespace {

// From the axis of a joint to the tip, square to the axis.
Eigen::Vector3d radial_of(const TipLinearisation& here, Eigen::Index joint) {
  const Eigen::Vector3d axis = here.joint_axes.col(joint);
  const Eigen::Vector3d lever = here.tip_mm - here.joint_origins_mm.col(joint);
  return lever - axis * axis.dot(lever);
}

}  // namespace

CircleRadiusResidual::CircleRadiusResidual(const ObservationGroup& group, std::vector<int> rows,
                                           Unknowns&)
    : Residual(group, std::move(rows)), encoder_rad_(encoders(group.encoder_rad)) {}

std::optional<std::string> CircleRadiusResidual::start(const ArmAt&, Unknowns&,
                                                       Eigen::VectorXd&) const {
  return std::nullopt;
}

void CircleRadiusResidual::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd&,
                                Eigen::Index first, Eigen::Index count,
                                const BlockRows& rows) const {
  const ForwardKinematics kinematics(at.arm);
  TipLinearisation here;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index joint = group().joint[static_cast<std::size_t>(this->row(first + k))] - 1;
    const auto posture = encoder_rad_.col(first + k);
    kinematics.linearise({posture.data(), static_cast<std::size_t>(posture.size())}, here);
    const Eigen::Vector3d radial = radial_of(here, joint);
    const double radius = radial.norm();
    double* row = rows.row(k);
    for (std::size_t i = 0; i < unknowns.free().size(); ++i) {
      // What lies before the axis carries axis and tip along; the turn about the axis itself
      // changes no radius.
      if (unknowns.columns()[i].joint < joint) continue;
      row[i] = radial.dot(here.J_tip_parameters.col(unknowns.free()[i])) / radius;
    }
    row[rows.columns] = radius - group().value_mm(this->row(first + k));
  }
}

ObservedPlaces CircleRadiusResidual::places(const ArmAt& at, const Unknowns&,
                                            const Eigen::VectorXd&) const {
  const ForwardKinematics kinematics(at.arm);
  TipLinearisation here;
  ObservedPlaces places{Eigen::Matrix3Xd(3, count()), Eigen::Matrix3Xd(3, count())};
  for (Eigen::Index i = 0; i < count(); ++i) {
    const auto posture = encoder_rad_.col(i);
    kinematics.linearise({posture.data(), static_cast<std::size_t>(posture.size())}, here);
    places.point_mm.col(i) = here.tip_mm;
    places.direction.col(i) =
        radial_of(here, group().joint[static_cast<std::size_t>(row(i))] - 1).normalized();
  }
  return places;
}

Eigen::MatrixXd CircleRadiusResidual::J_residual_encoders(const ArmModel& arm, const Unknowns&,
                                                          const Eigen::VectorXd&) const {
  const ForwardKinematics kinematics(arm);
  TipLinearisation here;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(count(), encoder_rad_.rows());
  for (Eigen::Index i = 0; i < count(); ++i) {
    const Eigen::Index joint = group().joint[static_cast<std::size_t>(row(i))] - 1;
    const auto posture = encoder_rad_.col(i);
    kinematics.linearise({posture.data(), static_cast<std::size_t>(posture.size())}, here);
    const Eigen::Vector3d outward = radial_of(here, joint).normalized();
    // Joints up to the axis carry it along.
    const Eigen::Index beyond = encoder_rad_.rows() - joint - 1;
    J.row(i).tail(beyond) = outward.transpose() * here.J_tip_encoder.rightCols(beyond);
  }
  return J;
}

}  // namespace armcal
