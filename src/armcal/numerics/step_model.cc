// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/step_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

// Above this condition number of the scaled Jacobian the normal equations, whose own is the square,
// leave fewer than six digits of a step.
constexpr double kCholeskyCondition = 1e5;
// A column of which less sticks out of the others is known to its derivatives' rounding only.
constexpr double kDependence = 1e-12;
// Below this a squared column length has no digits left to scale by.
constexpr double kSmallestSquare = 1e-290;
constexpr double kRadiusTolerance = 0.1;
constexpr int kMostSearches = 12;

}  // namespace

StepModel::StepModel(const NormalEquations& equations,
                     const std::function<TriangularSystem()>& triangular) {
  const Eigen::Index n = equations.gram.rows() - 1;
  scales_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double square = equations.gram(i, i);
    scales_(i) = square > kSmallestSquare ? std::sqrt(square) : 1.0;
  }
  const Eigen::VectorXd inverse = scales_.cwiseInverse();
  c_ = inverse.asDiagonal() * equations.gram.topLeftCorner(n, n) * inverse.asDiagonal();
  b_ = equations.gradient().transpose().cwiseProduct(inverse);
  weights_ = Eigen::VectorXd::Ones(n);

  auto cholesky = cholesky_factor(c_);
  if (cholesky && std::sqrt(cholesky->condition_number) <= kCholeskyCondition) {
    l_ = std::move(cholesky->l);
    rank_ = n;
    undamped_.scaled = l_.triangularView<Eigen::Lower>().solve(-b_);
    undamped_.predicted_decrease = undamped_.scaled.squaredNorm();
    l_.triangularView<Eigen::Lower>().transpose().solveInPlace(undamped_.scaled);
  } else {
    solve_by_qr(triangular());
  }
  undamped_.length = undamped_.scaled.norm();
}

void StepModel::solve_by_qr(const TriangularSystem& system) {
  r_ = system.r * scales_.cwiseInverse().asDiagonal();
  q_r_ = system.q_r;
  RankedSolution solution = shortest_solution(r_, -q_r_, kDependence);
  rank_ = solution.rank;
  undamped_.scaled = std::move(solution.x);
  undamped_.predicted_decrease = decrease(undamped_.scaled, 0.0);
}

void StepModel::weigh_lengths(const Eigen::VectorXd& weights) {
  weights_ = weights;
  undamped_.length = weights_.cwiseProduct(undamped_.scaled).norm();
}

double StepModel::decrease(const Eigen::VectorXd& step, double damping) const {
  const double damped = damping * weights_.cwiseProduct(step).squaredNorm();
  if (by_qr()) return (r_ * step).squaredNorm() + 2.0 * damped;
  return -b_.dot(step) + damped;
}

std::optional<StepModel::Damped> StepModel::damped(double damping) const {
  const Eigen::Index n = scales_.size();
  Damped result;
  if (by_qr()) {
    Eigen::MatrixXd stack = Eigen::MatrixXd::Zero(2 * n, n + 1);
    stack.topLeftCorner(n, n) = r_;
    stack.col(n).head(n) = -q_r_;
    stack.bottomLeftCorner(n, n).diagonal() = std::sqrt(damping) * weights_;
    triangularise(stack);
    if (!(stack.diagonal().head(n).cwiseAbs().minCoeff() > 0.0)) return std::nullopt;
    result.step =
        stack.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(stack.col(n).head(n));
    result.lower = stack.topLeftCorner(n, n).transpose();
    return result;
  }
  result.lower = c_;
  result.lower.diagonal().array() += damping * weights_.array().square();
  auto cholesky = cholesky_factor(result.lower);
  if (!cholesky) return std::nullopt;
  result.lower = std::move(cholesky->l);
  result.step = result.lower.triangularView<Eigen::Lower>().solve(-b_);
  result.lower.triangularView<Eigen::Lower>().transpose().solveInPlace(result.step);
  return result;
}

ModelStep StepModel::step_within(double radius, double damping) const {
  if (undamped_.length <= (1.0 + kRadiusTolerance) * radius) return undamped_;
  double low = 0.0;
  double high = b_.cwiseQuotient(weights_).norm() / radius;
  ModelStep best;
  for (int search = 0; search < kMostSearches; ++search) {
    if (!(damping > low && damping < high)) {
      damping = std::max(1e-3 * high, std::sqrt(low * high));
    }
    const auto candidate = damped(damping);
    if (!candidate) {
      low = damping;
      damping = 0.0;
      continue;
    }
    const Eigen::VectorXd weighted = weights_.cwiseProduct(candidate->step);
    best = {candidate->step, damping, weighted.norm(), decrease(candidate->step, damping)};
    const double excess = best.length - radius;
    if (std::abs(excess) <= kRadiusTolerance * radius || best.length == 0.0) return best;
    (excess > 0.0 ? low : high) = damping;
    const double bend = candidate->lower.triangularView<Eigen::Lower>()
                            .solve(weights_.cwiseProduct(weighted))
                            .squaredNorm();
    damping += best.length * best.length / bend * excess / radius;
  }
  return best;
}

std::optional<Eigen::MatrixXd> StepModel::inverse_factor() const {
  if (!full_rank()) return std::nullopt;
  const Eigen::Index n = scales_.size();
  std::optional<Eigen::MatrixXd> factor;
  if (by_qr()) {
    factor = armcal::inverse_factor(r_);
    if (!factor) return std::nullopt;
  } else {
    factor = l_.triangularView<Eigen::Lower>().transpose().solve(Eigen::MatrixXd::Identity(n, n));
  }
  return scales_.cwiseInverse().asDiagonal() * *factor;
}

double StepModel::condition_number() const {
  if (scales_.size() == 0) return 1.0;
  if (!by_qr()) {
    const Eigen::VectorXd values = symmetric_eigenvalues(c_);
    return std::sqrt(values(values.size() - 1) / values(0));
  }
  // The largest eigenvalues of R^T R and of its inverse; small ones of R^T R have no digits.
  const auto inverse = full_rank() ? armcal::inverse_factor(r_) : std::nullopt;
  if (!inverse) return std::numeric_limits<double>::infinity();
  const double largest = symmetric_eigenvalues(r_.transpose() * r_).maxCoeff();
  return std::sqrt(largest * symmetric_eigenvalues(*inverse * inverse->transpose()).maxCoeff());
}

}  // namespace armcal
