// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/check_rows.h"

namespace armcal {

struct Coverage {
  Eigen::Index inside = 0;
  Eigen::Index count = 0;
};

/// How many held-out residuals lie within the 95 % region that the covariance of the arm, of frames
/// and points that the fit knows, and the scatter of a reading predict together. Rows that place
/// their own frames are predicted a little too wide.
/// @param factor    rows: all unknowns of the fit; factor * factor^T is their covariance for stated
/// uncertainties
/// @param widening  of all standard uncertainties
[[nodiscard]] Coverage coverage_of(const CheckRows& check, const Unknowns& fitted,
                                   const Eigen::MatrixXd& factor, double widening);

}  // namespace armcal
