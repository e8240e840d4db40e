// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace armcal {

/// A text that hides nothing of what it is: control characters as the pictures that Unicode has for
/// them (browsers drop NUL), and characters that turn the direction of all that follows (U+202A to
/// U+202E, U+2066 to U+2069) as their codes, "[U+202E]". Letters of any direction stay.
[[nodiscard]] std::string visible_text(std::string_view utf8);

}  // namespace armcal
