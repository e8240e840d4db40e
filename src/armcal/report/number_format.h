// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace armcal {

/// A number with a fixed count of decimals; never "-0.000".
[[nodiscard]] std::string fixed(double value, int decimals);

/// Decimals that show `u` with two significant digits, at least 0 and at most 9.
[[nodiscard]] int decimals_for_uncertainty(double u);

/// "78.3120 +- 0.0021": the uncertainty with two significant digits, the value rounded to match
/// (GUM 7.2.6).
[[nodiscard]] std::string with_uncertainty(double value, double u);

}  // namespace armcal
