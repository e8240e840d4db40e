// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/numerics/least_squares_problem.h"

namespace armcal {

/// What makes the rows of observations uncorrelated and of standard deviation 1 where uncertain
/// encoders correlate them: L^-1 r, with L L^T = u^2 I + u_e^2 J J^T of each observation, J its
/// derivatives by the encoder readings. theory/identification.md eq. (18)
class Whitening {
 public:
  /// @param u_mm           of each observation
  /// @param u_encoder_rad  of each encoder reading
  /// @param J_encoders     rows: those of all observations, equally many each
  Whitening(const Eigen::VectorXd& u_mm, double u_encoder_rad, const Eigen::MatrixXd& J_encoders);

  /// Whitens rows of observations first .. in place.
  void apply(Eigen::Index first, Eigen::Index count, const BlockRows& rows) const;
  /// Trace of L L^T of an observation, mm^2.
  [[nodiscard]] double variance(Eigen::Index observation) const {
    return variances_[static_cast<std::size_t>(observation)];
  }
  /// Longest row of L^-1 of an observation, 1/mm.
  [[nodiscard]] double largest_weight(Eigen::Index observation) const;

 private:
  // L^-1 of an observation, row by row up to the diagonal.
  [[nodiscard]] const double* factor(Eigen::Index observation) const {
    return factors_.data() + observation * size_ * (size_ + 1) / 2;
  }

  Eigen::Index size_;  // rows of one observation
  std::vector<double> factors_;
  std::vector<double> variances_;
};

}  // namespace armcal
