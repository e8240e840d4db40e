// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "armcal/identification/calibration.h"
#include "armcal/report/document.h"

namespace armcal {

/// Keys: docs/commands/calibrate.md.
[[nodiscard]] Json json_result(const Calibration& calibration);

/// A report that can be pasted into a mail.
[[nodiscard]] std::string text_result(const Calibration& calibration);

/// The same for what a session would determine: no values, no residuals.
[[nodiscard]] Json json_of_identifiability(const Calibration& look);
[[nodiscard]] std::string text_of_identifiability(const Calibration& look);

}  // namespace armcal
