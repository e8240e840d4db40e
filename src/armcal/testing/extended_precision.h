// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace armcal::testing {

/// Linear least squares in extended precision (64 bits of mantissa on x86), a judge of what double
/// precision makes of ill-conditioned problems.
struct ExtendedSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd deviations;  ///< roots of the diagonal of (A^T A)^-1
};
[[nodiscard]] ExtendedSolution solve_in_extended_precision(const Eigen::MatrixXd& a,
                                                           const Eigen::VectorXd& b);

}  // namespace armcal::testing
