// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// "24 points at position B, 25 are asked for"; nothing where the number is as asked.
/// @param thing  in the singular: "point"
/// @param place  " at position B", or nothing
void add_unless_as_asked(std::vector<std::string>& missing, std::size_t count, std::size_t asked,
                         std::string_view thing, std::string_view place = {});

/// The unit that explains a value too far from what it should be: "25.4 times too small, as if in
/// inches". Nothing where the ratio is within 5 % of none of 10, 25.4, 100, 1000 either way.
[[nodiscard]] std::optional<std::string> unit_that_explains(double value, double expected);

}  // namespace armcal
