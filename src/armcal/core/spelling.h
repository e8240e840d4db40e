// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// Number of insertions, deletions, substitutions and swaps of neighbours that turn one word into
/// the other.
[[nodiscard]] std::size_t edit_distance(std::string_view one, std::string_view other);

/// `did you mean "distance_mm"?` for the known name nearest to `typed`; without a near one the list
/// of known names (`known: a, b, c`), so that the reader can always act on it.
[[nodiscard]] std::string did_you_mean(std::string_view typed, std::span<const std::string> known);

/// Does `name` match the shell-like `pattern` (`*` any run, `?` any one character)?
[[nodiscard]] bool matches_glob(std::string_view name, std::string_view pattern);

/// A word as a POSIX shell reads it back: in single quotes where it needs them.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace armcal
