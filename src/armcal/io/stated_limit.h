// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armcal {

/// A limit as makers state it: A, A + L/K or min(A + L/K, B), of a length L.
struct StatedLimit {
  double constant_mm = 0.0;           ///< A
  double per_length = 0.0;            ///< 1/K, mm per mm
  std::optional<double> largest_mm;   ///< B
};

/// Reads a maker's formula: micrometres, with L in millimetres. "30", "20 + L/50" and
/// "min(20 + L/50, 80)" are all there is; blanks do not matter.
/// @return nothing where the text is none of these, where a number is negative or none is larger
/// than 0
[[nodiscard]] std::optional<StatedLimit> limit_of_formula(std::string_view text);

}  // namespace armcal
