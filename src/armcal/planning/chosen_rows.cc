// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/chosen_rows.h"

#include <cmath>
#include <utility>

#include "armcal/numerics/linear_algebra.h"

namespace armcal {

double update_inverse(Eigen::MatrixXd& inverse, const Eigen::VectorXd& row, double sign) {
  const Eigen::VectorXd way = inverse * row;
  const double factor = 1.0 + sign * row.dot(way);
  inverse.noalias() -= (sign / factor) * way * way.transpose();
  return factor;
}

ChosenRows::ChosenRows(const Eigen::MatrixXd& design, std::vector<int> rows)
    : design_(&design), rows_(std::move(rows)), taken_(static_cast<std::size_t>(design.rows())) {
  for (const int row : rows_) taken_[static_cast<std::size_t>(row)] = true;
  renew();
}

Eigen::VectorXd ChosenRows::gains(std::size_t place) const {
  const int out = rows_[place];
  const Eigen::VectorXd across = *design_ * (covariance_ * design_->row(out).transpose());
  Eigen::VectorXd gain =
      ((1.0 + variance_.array()) * (1.0 - variance_(out)) + across.array().square()).matrix();
  for (const int row : rows_) gain(row) = 0.0;
  return gain;
}

Eigen::VectorXd ChosenRows::likeness(int row) const {
  const Eigen::VectorXd across = *design_ * (covariance_ * design_->row(row).transpose());
  return (across.array().square() / (1.0 + variance_.array())).matrix();
}

void ChosenRows::exchange(std::size_t place, int in) {
  const int out = rows_[place];
  add(in, 1.0);
  add(out, -1.0);
  taken_[static_cast<std::size_t>(out)] = false;
  taken_[static_cast<std::size_t>(in)] = true;
  rows_[place] = in;
}

void ChosenRows::renew() {
  const auto factor = inverse_factor(chosen());
  singular_ = !factor.has_value();
  if (singular_) return;
  covariance_ = *factor * factor->transpose();
  variance_ = (*design_ * *factor).rowwise().squaredNorm();
  Eigen::MatrixXd triangle = chosen();
  triangularise(triangle);
  log_determinant_ = 2.0 * triangle.diagonal().cwiseAbs().array().log().sum();
}

void ChosenRows::add(int row, double sign) {
  const Eigen::VectorXd across = *design_ * (covariance_ * design_->row(row).transpose());
  const double factor = update_inverse(covariance_, design_->row(row).transpose(), sign);
  variance_.array() -= sign * across.array().square() / factor;
}

}  // namespace armcal
