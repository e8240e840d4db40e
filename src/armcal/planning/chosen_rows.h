// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace armcal {

/// The inverse of M + sign * row row^T from that of M (Sherman and Morrison). Returns the factor by
/// which the determinant of M grows.
double update_inverse(Eigen::MatrixXd& inverse, const Eigen::VectorXd& row, double sign);

/// A choice of rows of a design with the inverse of their information matrix and the variance that
/// each row of the design would be predicted with, both kept up by rank-one updates.
class ChosenRows {
 public:
  /// @param design  kept by reference
  ChosenRows(const Eigen::MatrixXd& design, std::vector<int> rows);

  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }
  [[nodiscard]] bool is_taken(Eigen::Index row) const {
    return taken_[static_cast<std::size_t>(row)];
  }
  /// The rows do not determine all unknowns; nothing else is then valid.
  [[nodiscard]] bool is_singular() const { return singular_; }
  [[nodiscard]] const Eigen::MatrixXd& covariance() const { return covariance_; }
  [[nodiscard]] Eigen::MatrixXd chosen() const { return (*design_)(rows_, Eigen::all); }
  [[nodiscard]] double log_determinant() const { return log_determinant_; }  ///< as of `renew`

  /// By which factor the determinant grows when place `place` is given to each row, 0 for rows that
  /// are chosen already. theory/complete_symmetric_point.md eq. (7)
  [[nodiscard]] Eigen::VectorXd gains(std::size_t place) const;
  /// Which rows would look most after row `row`: the share of their predictions that is common.
  [[nodiscard]] Eigen::VectorXd likeness(int row) const;

  void exchange(std::size_t place, int in);
  /// Everything from the rows themselves: rank-one updates collect rounding.
  void renew();

 private:
  void add(int row, double sign);

  const Eigen::MatrixXd* design_;
  std::vector<int> rows_;
  std::vector<bool> taken_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd variance_;  // of the prediction of every row
  double log_determinant_ = 0.0;
  bool singular_ = false;
};

}  // namespace armcal
