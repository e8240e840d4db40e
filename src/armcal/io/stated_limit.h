// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armcal {

/// A limit as makers state it: A, A + L/K or min(A + L/K, B), where A and B are micrometres, K has
/// no unit and the length L is in millimetres.
struct StatedLimit {
  double a_mm = 0.0;
  std::optional<double> k;
  std::optional<double> b_mm;
};

/// Reads a maker's formula: "30", "20 + L/50" and "min(20 + L/50, 80)" are all there is; blanks do
/// not matter.
/// @return nothing where the text is none of these, where a number is negative, a constant or K is
/// 0, or B is not larger than A
[[nodiscard]] std::optional<StatedLimit> limit_of_formula(std::string_view text);

}  // namespace armcal
