// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/identification/calibration.h"
#include "armcal/identification/residuals/residual.h"

namespace armcal {

/// Residual of one observation at some values of the unknowns.
struct ObservationResidual {
  const Residual* residual = nullptr;
  Eigen::Index observation = 0;
  double length_mm =
      0.0;  ///< root of the sum of squares of its rows; poses: of the mean over their three points
  /// Measured - predicted of its first rows, mm: x y z, or the one number that a kind compares.
  Eigen::Vector3d first_mm = Eigen::Vector3d::Zero();
  RowComponents components;  ///< all its rows, measured - predicted, whitened
};

/// Of all observations, one residual after the other.
[[nodiscard]] std::vector<ObservationResidual> residuals_of_observations(
    const std::vector<const Residual*>& residuals, const Unknowns& unknowns,
    const Eigen::VectorXd& x);
/// The same on another arm than that at x.
[[nodiscard]] std::vector<ObservationResidual> residuals_of_observations(
    const std::vector<const Residual*>& residuals, const ArmModel& arm, const Unknowns& unknowns,
    const Eigen::VectorXd& x);

[[nodiscard]] ResidualStatistics statistics_of(const std::vector<ObservationResidual>& residuals,
                                               const ObservationGroup& group);

/// Rows that lie so far out that chance alone would put one there in a hundred such sets. The usual
/// size is taken from the median, which a few of them do not move. Worst first.
[[nodiscard]] std::vector<FlaggedRow> flagged_rows(
    const std::vector<ObservationResidual>& residuals, bool is_check);

}  // namespace armcal
