// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace armcal {

/// A number with a fixed count of decimals; never "-0.000". Negative: rounded to tens, hundreds ..
[[nodiscard]] std::string fixed(double value, int decimals);

/// Decimals that show `u` with two significant digits, at most 9; negative where u is 100 or more.
[[nodiscard]] int decimals_for_uncertainty(double u);

/// "78.3120 +- 0.0021": the uncertainty with two significant digits, the value rounded to match
/// (GUM 7.2.6).
[[nodiscard]] std::string with_uncertainty(double value, double u);

}  // namespace armcal
