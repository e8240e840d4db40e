// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/derivative_check.h"

#include <algorithm>
#include <array>
#include <complex>
#include <limits>

#include "armcal/core/invariant.h"

namespace armcal {

Eigen::MatrixXd jacobian_by_complex_step(const ComplexFunction& f, const Eigen::VectorXd& x) {
  // So small that its square vanishes beside any value: no truncation error is left.
  constexpr double kStep = 1e-100;
  Eigen::VectorXcd point = x.cast<std::complex<double>>();
  Eigen::MatrixXd jacobian;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    point(j) = std::complex<double>(x(j), kStep);
    const Eigen::VectorXcd value = f(point);
    if (j == 0) jacobian.resize(value.size(), x.size());
    jacobian.col(j) = value.imag() / kStep;
    point(j) = x(j);
  }
  return jacobian;
}

Eigen::MatrixXd jacobian_by_differences(const RealFunction& f, const Eigen::VectorXd& x,
                                        const Eigen::VectorXd& steps) {
  ARMCAL_INVARIANT(x.size() == steps.size());
  constexpr std::size_t kLevels = 5;
  Eigen::MatrixXd jacobian;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const auto central = [&](double h) -> Eigen::VectorXd {
      Eigen::VectorXd point = x;
      point(j) = x(j) + h;
      const Eigen::VectorXd above = f(point);
      point(j) = x(j) - h;
      return (above - f(point)) / (2.0 * h);
    };
    // Richardson's table: each row halves the step, each column removes one even power of it.
    std::array<Eigen::VectorXd, kLevels> row;
    Eigen::VectorXd best;
    double best_change = std::numeric_limits<double>::infinity();
    double h = steps(j);
    for (std::size_t level = 0; level < kLevels; ++level, h /= 2.0) {
      std::array<Eigen::VectorXd, kLevels> next;
      next[0] = central(h);
      double factor = 4.0;
      for (std::size_t k = 1; k <= level; ++k, factor *= 4.0) {
        next[k] = next[k - 1] + (next[k - 1] - row[k - 1]) / (factor - 1.0);
      }
      if (level > 0) {
        const double change = (next[level] - row[level - 1]).lpNorm<Eigen::Infinity>();
        if (change < best_change) {
          best_change = change;
          best = next[level];
        }
      }
      row = next;
    }
    if (j == 0) jacobian.resize(best.size(), x.size());
    jacobian.col(j) = best;
  }
  return jacobian;
}

double worst_relative_difference(const Eigen::MatrixXd& analytic,
                                 const Eigen::MatrixXd& reference) {
  ARMCAL_INVARIANT(analytic.rows() == reference.rows() && analytic.cols() == reference.cols());
  if (!analytic.allFinite()) return std::numeric_limits<double>::infinity();
  double worst = 0.0;
  for (Eigen::Index j = 0; j < reference.cols(); ++j) {
    const double largest = reference.col(j).lpNorm<Eigen::Infinity>();
    const double scale = largest > 1e-300 ? largest : 1.0;
    const double difference = (analytic.col(j) - reference.col(j)).lpNorm<Eigen::Infinity>();
    worst = std::max(worst, difference / scale);
  }
  return worst;
}

}  // namespace armcal
