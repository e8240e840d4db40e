// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "armcal/comparison/method.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// All zeros, links and the tip: what is written down for an arm, redundant or not. Without beta
/// where it is 0, and without harmonics. Table indices.
[[nodiscard]] std::vector<int> written_parameters(const ArmModel& arm);

/// Least squares of every written parameter at once, redundant directions and all: what papers do
/// that then report that least squares fails. Levenberg-Marquardt, which keeps the steps finite;
/// the optimum is not a point but a surface, so the arm found depends on the start, no
/// uncertainties exist, and the condition number is that of rounding.
/// @throws NumericalError where it does not even start
[[nodiscard]] FoundArm redundant_fit(const ArmModel& nominal,
                                     std::span<const ObservationGroup> groups,
                                     const Monitor& monitor);

/// The same by twenty undamped Gauss-Newton steps x <- x - (J^T J)^-1 J^T r in mm and rad, the
/// inverse taken as it comes: how the linearised least squares of papers are written down. With
/// redundant columns that matrix has no inverse, and its rounding decides what the steps are.
/// @throws NumericalError where the steps leave all numbers behind
[[nodiscard]] FoundArm plain_gauss_newton(const ArmModel& nominal,
                                          std::span<const ObservationGroup> groups,
                                          const Monitor& monitor);

}  // namespace armcal
