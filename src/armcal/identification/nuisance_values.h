// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/identification/calibration.h"
#include "armcal/identification/unknowns.h"

namespace armcal {

/// What observations brought along, as people want to read it: frames as position of the origin and
/// rotation vector, each with its standard uncertainty. A step of a frame turns about its pivot, so
/// the origin depends on both parts.
/// @param factor  rows: all unknowns; factor * factor^T is their covariance
[[nodiscard]] std::vector<NuisanceValue> nuisance_values(const Unknowns& unknowns,
                                                         const Eigen::VectorXd& x,
                                                         const Eigen::MatrixXd& factor);

}  // namespace armcal
