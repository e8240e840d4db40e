// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "armcal/arm/arm_model.h"

namespace armcal {

/// The true arm in the words of a found one: what that held has the value at which it is held, and
/// everything else is what moves the tips like the truth. A parameter that readings do not see has
/// no true value of its own, only together with others.
/// @param free  table indices of what was estimated
/// @param encoder_rad, true_mm  postures, a column each, and the true tips there: as many as tell
/// all that points can
/// @return in table order; NaN where also these points do not tell the parameter
[[nodiscard]] Eigen::VectorXd true_values(const ArmModel& found, std::span<const int> free,
                                          const Eigen::MatrixXd& encoder_rad,
                                          std::span<const Eigen::Vector3d> true_mm);

struct IntervalCount {
  int inside = 0;
  int count = 0;
};

/// How many of the estimated parameters have their true value within the 95 % interval; those
/// without a true value are not counted.
/// @param u  standard uncertainties of `free`
[[nodiscard]] IntervalCount count_intervals(const ArmModel& found, std::span<const int> free,
                                            const Eigen::VectorXd& u,
                                            const Eigen::VectorXd& true_values);

}  // namespace armcal
