// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/reversal.h"

namespace armcal {

ReversalResidual::ReversalResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns&)
    : Residual(group, std::move(rows)),
      before_(encoders(group.encoder_rad)),
      after_(encoders(group.encoder_end_rad)) {}

std::optional<std::string> ReversalResidual::start(const ArmAt&, Unknowns&,
                                                   Eigen::VectorXd&) const {
  return std::nullopt;
}

void ReversalResidual::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd&,
                            Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  const Eigen::Index columns = unknowns.arm_size();
  std::vector<double> work(static_cast<std::size_t>(6 * count * columns + 6 * count));
  double* const J_before = work.data();
  double* const J_after = J_before + 3 * count * columns;
  double* const tips_before = J_after + 3 * count * columns;
  double* const tips_after = tips_before + 3 * count;
  at.tips.fill(before_, first, count, {tips_before, J_before, columns});
  at.tips.fill(after_, first, count, {tips_after, J_after, columns});
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d step = Eigen::Map<const Eigen::Vector3d>(tips_before + 3 * k) -
                                 Eigen::Map<const Eigen::Vector3d>(tips_after + 3 * k);
    const double distance = step.norm();
    double* row = rows.row(k);
    for (Eigen::Index i = 0; i < columns; ++i) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        const Eigen::Index place = (3 * k + c) * columns + i;
        row[i] += step(c) / distance * (J_before[place] - J_after[place]);
      }
    }
    row[rows.columns] = distance - group().value_mm(this->row(first + k));
  }
}

ObservedPlaces ReversalResidual::places(const ArmAt& at, const Unknowns&,
                                        const Eigen::VectorXd&) const {
  ObservedPlaces places{all_tips(at.tips, before_), {}};
  places.direction = (places.point_mm - all_tips(at.tips, after_)).colwise().normalized();
  return places;
}

Eigen::MatrixXd ReversalResidual::J_residual_encoders(const ArmModel& arm, const Unknowns&,
                                                      const Eigen::VectorXd&) const {
  const Eigen::MatrixXd before_rad = encoders(group().encoder_rad);
  const Eigen::MatrixXd after_rad = encoders(group().encoder_end_rad);
  const MovingPoints before = moving_tips(arm, before_rad);
  const MovingPoints after = moving_tips(arm, after_rad);
  const Eigen::Index joints = before_rad.rows();
  Eigen::MatrixXd J(count(), 2 * joints);
  for (Eigen::Index i = 0; i < count(); ++i) {
    const Eigen::Vector3d along = (before.at_mm.col(i) - after.at_mm.col(i)).normalized();
    J.row(i) << along.transpose() * before.J_encoders.middleRows<3>(3 * i),
        -along.transpose() * after.J_encoders.middleRows<3>(3 * i);
    // A locked joint that shows the same at both ends was read once, with one error.
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      if (before_rad(joint, i) != after_rad(joint, i)) continue;
      J(i, joint) += J(i, joints + joint);
      J(i, joints + joint) = 0.0;
    }
  }
  return J;
}

}  // namespace armcal
