// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/identification/stylus.h"
#include "armcal/report/document.h"
#include "armcal/verification/verdict.h"

namespace armcal {

/// Is the tip known well enough? not_judged without a limit of U.
[[nodiscard]] Verdict verdict_of(const StylusQualification& stylus,
                                 const std::optional<double>& limit_mm);

/// Keys: those of a calibration, and docs/commands/probe.md.
[[nodiscard]] Json json_result(const StylusQualification& stylus,
                               const std::optional<double>& limit_mm);
[[nodiscard]] std::string text_result(const StylusQualification& stylus,
                                      const std::optional<double>& limit_mm);

}  // namespace armcal
