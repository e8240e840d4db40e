// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "armcal/identification/calibration.h"
#include "armcal/report/document.h"

namespace armcal {

struct SessionEstimate;

/// Keys: docs/commands/calibrate.md.
[[nodiscard]] Json json_result(const Calibration& calibration);

/// The same with what was asked for and every row of the readings.
[[nodiscard]] Json json_result(const Calibration& calibration,
                               std::span<const ObservationGroup> groups,
                               const SessionEstimate& asked);

/// A report that can be pasted into a mail.
[[nodiscard]] std::string text_result(const Calibration& calibration);

/// The same for what a session would determine: no values, no residuals.
[[nodiscard]] Json json_of_identifiability(const Calibration& look);
[[nodiscard]] std::string text_of_identifiability(const Calibration& look);

}  // namespace armcal
