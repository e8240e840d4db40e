// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/report/text_table.h"

namespace armcal {

// Cells of tables that set methods side by side.

/// "0.0031 s", "12 s": two digits say all that a time measured once can say.
[[nodiscard]] std::string seconds_cell(double seconds);
/// Millimetres: a tenth of a micrometre, but not beside an error of a millimetre.
[[nodiscard]] std::string error_cell(double error_mm);
/// A multiple: "1.04", "46".
[[nodiscard]] std::string ratio_cell(double ratio);
/// "23", "2e+16", empty where there is none.
[[nodiscard]] std::string condition_cell(const std::optional<double>& number);

}  // namespace armcal
