// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/whitening.h"

#include <algorithm>
#include <cmath>

namespace armcal {
namespace {

// L of u^2 I + E E^T, in the lower triangle.
Eigen::MatrixXd cholesky(double u, const Eigen::MatrixXd& E) {
  Eigen::MatrixXd L = E * E.transpose();
  L.diagonal().array() += u * u;
  for (Eigen::Index j = 0; j < L.cols(); ++j) {
    for (Eigen::Index k = 0; k < j; ++k)
      L.col(j).tail(L.rows() - j) -= L(j, k) * L.col(k).tail(L.rows() - j);
    // No pivot is below u^2 but by rounding.
    const double pivot = std::sqrt(std::max(L(j, j), u * u));
    L.col(j).tail(L.rows() - j) /= pivot;
    L(j, j) = pivot;
  }
  return L;
}

// Appends L^-1, row by row up to the diagonal.
void append_inverse(const Eigen::MatrixXd& L, std::vector<double>& factors) {
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(L.rows(), L.cols());
  for (Eigen::Index r = 0; r < L.rows(); ++r) {
    inverse(r, r) = 1.0;
    for (Eigen::Index k = 0; k < r; ++k) inverse.row(r) -= L(r, k) * inverse.row(k);
    inverse.row(r) /= L(r, r);
    for (Eigen::Index c = 0; c <= r; ++c) factors.push_back(inverse(r, c));
  }
}

}  // namespace

Whitening::Whitening(const Eigen::VectorXd& u_mm, double u_encoder_rad,
                     const Eigen::MatrixXd& J_encoders)
    : size_(u_mm.size() > 0 ? J_encoders.rows() / u_mm.size() : 0) {
  factors_.reserve(static_cast<std::size_t>(u_mm.size() * size_ * (size_ + 1) / 2));
  for (Eigen::Index i = 0; i < u_mm.size(); ++i) {
    const Eigen::MatrixXd E = u_encoder_rad * J_encoders.middleRows(i * size_, size_);
    append_inverse(cholesky(u_mm(i), E), factors_);
    variances_.push_back(static_cast<double>(size_) * u_mm(i) * u_mm(i) + E.squaredNorm());
  }
}

void Whitening::apply(Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  for (Eigen::Index k = 0; k < count; ++k) {
    // From the last row up: a row needs those above it as they were.
    for (Eigen::Index r = size_ - 1; r >= 0; --r) {
      const double* const weights = factor(first + k) + r * (r + 1) / 2;
      double* const row = rows.row(size_ * k + r);
      for (Eigen::Index i = 0; i < rows.stride; ++i) row[i] *= weights[r];
      for (Eigen::Index c = 0; c < r; ++c) {
        const double weight = weights[c];
        const double* const other = rows.row(size_ * k + c);
        for (Eigen::Index i = 0; i < rows.stride; ++i) row[i] += weight * other[i];
      }
    }
  }
}

double Whitening::largest_weight(Eigen::Index observation) const {
  const double* weights = factor(observation);
  double largest = 0.0;
  for (Eigen::Index r = 0; r < size_; weights += ++r) {
    largest = std::max(largest, Eigen::Map<const Eigen::VectorXd>(weights, r + 1).norm());
  }
  return largest;
}

}  // namespace armcal
