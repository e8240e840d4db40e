// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace armcal {

// The decompositions that the rest of the house needs, on matrices of any size. They are compiled
// here and nowhere else: each instance of Eigen's templates costs ten seconds of every build.

/// The numbers of a vector, for what takes a span.
[[nodiscard]] inline std::span<const double> as_span(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}
void as_span(Eigen::VectorXd&&) = delete;  // they would be gone
/// Those of a column of a matrix.
template <class Matrix>
[[nodiscard]] std::span<const double> as_span(
    const Eigen::Block<Matrix, Eigen::Dynamic, 1, true>& column) {
  return {column.data(), static_cast<std::size_t>(column.size())};
}

/// Rounding of a sum of squares, as a share of it.
inline constexpr double kSumRounding = 1e-13;

/// The x of least |x| among those of least |A x - b|. Complete orthogonal decomposition (QR with
/// column exchange), so rank-deficient A is welcome.
[[nodiscard]] Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

struct RankedSolution {
  Eigen::VectorXd x;
  Eigen::Index rank = 0;
};

/// The same, with the rank that was found: columns count as dependent when less than `tolerance` of
/// the longest one sticks out.
[[nodiscard]] RankedSolution shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                               double tolerance);

/// Replaces `a` (at least as many rows as columns) by R of its QR decomposition, zeros below.
/// Householder, without column exchange.
void triangularise(Eigen::Ref<Eigen::MatrixXd> a);

/// L with L L^T = a, of which the lower triangle is read, in the lower triangle; and an estimate of
/// the condition number of a (in the 1-norm, within a factor of n of the usual one). Nothing when a
/// is not positive definite to rounding.
struct CholeskyFactor {
  Eigen::MatrixXd l;
  double condition_number = 0.0;
};
[[nodiscard]] std::optional<CholeskyFactor> cholesky_factor(const Eigen::MatrixXd& a);

/// Eigenvalues of a symmetric matrix, rising; its lower triangle is read.
[[nodiscard]] Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& a);

/// W with W W^T = (A^T A)^-1, by QR of A with its columns scaled to unit length; nothing when A has
/// fewer rows than columns, is not finite, or a column depends on the others to rounding.
[[nodiscard]] std::optional<Eigen::MatrixXd> inverse_factor(const Eigen::MatrixXd& a);

/// A = u * diag(values) * v^T, values falling; u and v have min(rows, columns) columns.
struct SingularValueDecomposition {
  Eigen::MatrixXd u;
  Eigen::VectorXd values;
  Eigen::MatrixXd v;
};
/// One-sided Jacobi: small singular values keep their relative accuracy.
[[nodiscard]] SingularValueDecomposition singular_value_decomposition(const Eigen::MatrixXd& a);

/// Lengths of the columns, 1 where a column is zero: the scales that make mm and rad comparable.
[[nodiscard]] Eigen::VectorXd column_scales(const Eigen::MatrixXd& a);

}  // namespace armcal
