// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "armcal/report/html/language.h"

namespace armcal {

/// A phrase of a result document ("24 points at position B, 25 are asked for") in the language of
/// the reader. Documents are worded in English; the phrases that armcal makes are the English texts
/// under a key, with {0}, {1}, .. for names and numbers, and the other languages have the same
/// keys. What matches none stays as it is: names and notes of users.
///
/// Of several that match, the one counts that leaves the least to its slots. Each slot holds at
/// least a character, and as few as will do.
/// @param under  keys of the phrases, which end with "phrase": "verification.phrase"
[[nodiscard]] std::string in_language(const std::string& phrase, std::string_view under,
                                      const Language& say);

}  // namespace armcal
