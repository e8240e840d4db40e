// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "armcal/identification/calibration.h"
#include "armcal/report/document.h"

namespace armcal {

/// Every row of a calibration as one object of equally long columns (docs/commands/calibrate.md).
/// Rounded far below what any instrument shows, since digits are most of a document: residuals to
/// 1e-9 mm, places to 1e-6 mm, angles to 1e-10 deg, normalised ones to 1e-6.
/// @param groups  that were calibrated
[[nodiscard]] Json json_of_rows(const Calibration& calibration,
                                std::span<const ObservationGroup> groups);

}  // namespace armcal
