// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/residual.h"

#include "armcal/core/invariant.h"

namespace armcal {

ObservedPlaces Residual::places(const ArmAt&, const Unknowns&, const Eigen::VectorXd&) const {
  return {};
}

void Residual::weigh(const ArmModel& arm, const Unknowns& unknowns, const Eigen::VectorXd& x) {
  if (!(group_->u_encoder_rad > 0.0)) return;
  Eigen::VectorXd u_mm(count());
  for (Eigen::Index i = 0; i < count(); ++i) u_mm(i) = group_->u_mm(row(i));
  whitening_.emplace(u_mm, group_->u_encoder_rad, J_residual_encoders(arm, unknowns, x));
}

void Residual::whiten(Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  if (whitening_) {
    whitening_->apply(first, count, rows);
    return;
  }
  ARMCAL_INVARIANT(!(group_->u_encoder_rad > 0.0));  // weigh() has been forgotten
  const Eigen::Index values = rows_per_observation() * rows.stride;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double weight = 1.0 / group_->u_mm(row(first + k));
    double* const from = rows.data + values * k;
    for (double* value = from; value < from + values; ++value) *value *= weight;
  }
}

double Residual::variance(Eigen::Index i) const {
  if (whitening_) return whitening_->variance(i);
  const double u_mm = group_->u_mm(row(i));
  return static_cast<double>(rows_per_observation()) * u_mm * u_mm;
}

double Residual::largest_weight(Eigen::Index i) const {
  return whitening_ ? whitening_->largest_weight(i) : 1.0 / group_->u_mm(row(i));
}

std::string start_all(const std::vector<std::unique_ptr<Residual>>& residuals, const ArmAt& at,
                      Unknowns& unknowns, Eigen::VectorXd& x) {
  std::string problems;
  for (const bool lengths : {false, true}) {
    for (const auto& residual : residuals) {
      if ((residual->group().kind == ReferenceKind::length) != lengths) continue;
      if (const auto problem = residual->start(at, unknowns, x)) {
        problems += (problems.empty() ? "" : "; ") + *problem;
      }
    }
  }
  return problems;
}

void weigh_all(const std::vector<std::unique_ptr<Residual>>& residuals, const Unknowns& unknowns,
               const Eigen::VectorXd& x) {
  const ArmModel arm = unknowns.arm_at(x);
  for (const auto& residual : residuals) residual->weigh(arm, unknowns, x);
}

Eigen::MatrixXd Residual::encoders(const Eigen::MatrixXd& of_group) const {
  Eigen::MatrixXd own(of_group.rows(), count());
  for (Eigen::Index i = 0; i < count(); ++i) own.col(i) = of_group.col(row(i));
  return own;
}

Eigen::Matrix3Xd Residual::all_tips(const TipRows& tips, const PosturePacks& postures) {
  Eigen::Matrix3Xd result(3, postures.count());
  tips.fill(postures, 0, postures.count(), {.tips = result.data()});
  return result;
}

}  // namespace armcal
