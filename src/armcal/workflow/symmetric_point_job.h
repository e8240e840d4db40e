// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/symmetric_point/analysis.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// Reads a procedure (*.symmetric.toml), its arm and its raw points, and analyses them. @param
/// compare_path an arm file whose lengths are held against the readings. @throws InputError,
/// NumericalError where the readings determine nothing
[[nodiscard]] SymmetricPointAnalysis run_symmetric_point(
    InputFiles& files, const std::string& path, const std::optional<std::string>& compare_path,
    const TableOptions& options);

}  // namespace armcal
