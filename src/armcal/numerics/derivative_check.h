// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>

namespace armcal {

// The shared derivative checker: every analytic Jacobian in this project meets it in a test, and
// users who add a kind of reading meet it in theirs.

using ComplexFunction = std::function<Eigen::VectorXcd(const Eigen::VectorXcd&)>;
using RealFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Jacobian of `f` at `x` by complex steps (Squire and Trapp, SIAM Review 40 (1998) 110-112): exact
/// to rounding. `f` must be written without abs, conj or comparisons of complex values.
[[nodiscard]] Eigen::MatrixXd jacobian_by_complex_step(const ComplexFunction& f,
                                                       const Eigen::VectorXd& x);

/// Jacobian of `f` at `x` by central differences with Richardson extrapolation, for functions that
/// exist in real arithmetic only. @param steps first step for each unknown, the natural size of its
/// changes; relative accuracy about 1e-10 for smooth functions.
[[nodiscard]] Eigen::MatrixXd jacobian_by_differences(const RealFunction& f,
                                                      const Eigen::VectorXd& x,
                                                      const Eigen::VectorXd& steps);

/// Largest |analytic - reference| of any entry, relative to the largest entry of its column.
/// Columns that are zero in the reference (to 1e-300) count by their absolute value. Infinite when
/// `analytic` has a NaN.
[[nodiscard]] double worst_relative_difference(const Eigen::MatrixXd& analytic,
                                               const Eigen::MatrixXd& reference);

}  // namespace armcal
