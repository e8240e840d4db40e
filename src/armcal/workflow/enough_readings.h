// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "armcal/identification/calibration.h"

namespace armcal {

/// Whether readings are so few that no choice of postures could determine the arm: fewer equations
/// than unknowns. What postures at random in any number would determine counts as the unknowns of
/// the arm. Nothing where there are enough, where there are none to be fitted, or where priors
/// help.
/// @return in words, with the numbers
[[nodiscard]] std::optional<std::string> too_few_readings(std::span<const ObservationGroup> groups,
                                                          const ArmModel& nominal,
                                                          const CalibrationOptions& options);

}  // namespace armcal
