// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/circle_radius.h"

#include "armcal/arm/forward_kinematics.h"

namespace armcal {

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
    const Eigen::Vector3d axis = here.joint_axes.col(joint);
    const Eigen::Vector3d lever = here.tip_mm - here.joint_origins_mm.col(joint);
    const Eigen::Vector3d radial = lever - axis * axis.dot(lever);
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

}  // namespace armcal
