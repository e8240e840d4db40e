// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/arm/arm_model.h"
#include "armcal/core/diagnostics.h"
#include "armcal/io/text_file.h"

namespace armcal {

/// Reads an arm file (*.arm.toml, schema armcal.arm/1: docs/files/arm.md): lengths mm, angles deg,
/// what is missing is 0. All problems go to `diagnostics`; with errors nothing is returned.
[[nodiscard]] std::optional<ArmModel> read_arm(const TextFile& file, Diagnostics& diagnostics);

/// The text of an arm file. Reading it back gives the same lengths to the last digit and the same
/// angles as far as degrees can say them (exactly, when they came from degrees; else to 2e-16).
[[nodiscard]] std::string arm_text(const ArmModel& arm);

}  // namespace armcal
