// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "armcal/identification/residuals/residual.h"
#include "armcal/identification/unknowns.h"

namespace armcal {

/// Held-out rows on an arm that is not fitted any more.
struct CheckRows {
  std::vector<std::unique_ptr<Residual>> residuals;
  Unknowns unknowns;  ///< no free parameter of the arm
  Eigen::VectorXd x;  ///< with what the fit found; what only these rows know, found from them
  /// Frames, points, spheres and planes found anew from these rows alone; nothing where they are
  /// too few.
  std::optional<Eigen::VectorXd> registered;
};

/// @param fitted, x  the unknowns of the fit and their values
[[nodiscard]] CheckRows check_rows_of(std::span<const ObservationGroup> groups,
                                      const Unknowns& fitted, const Eigen::VectorXd& x,
                                      const Monitor& monitor);

/// Values of the unknowns of held-out rows before anything was fitted: what the fit knows as it
/// started, the rest from these rows on the nominal arm; nothing where they are too few.
/// @param fitted_places  start values of all that the fit knows beside the arm
[[nodiscard]] std::optional<Eigen::VectorXd> start_of_check_rows(
    const CheckRows& check, const ArmModel& nominal, const Eigen::VectorXd& fitted_places,
    std::size_t fitted_nuisances);

}  // namespace armcal
