// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "armcal/identification/residual_statistics.h"

namespace armcal {

/// The rows that observations came from, with their places in space: one entry per observation, in
/// their order.
/// @param residuals           as `residuals_of_observations` has them for these unknowns
/// @param nominal_lengths_mm  of the same observations on the nominal arm; empty: not known
[[nodiscard]] std::vector<RowResidual> row_residuals(
    const std::vector<ObservationResidual>& residuals,
    const std::vector<double>& nominal_lengths_mm, const Unknowns& unknowns,
    const Eigen::VectorXd& x, std::span<const ObservationGroup> groups);

/// By group, then in file order.
void sort_rows(std::vector<RowResidual>& rows);

[[nodiscard]] std::vector<double> lengths_of(const std::vector<ObservationResidual>& residuals);

}  // namespace armcal
