// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace armcal {

/// Ends the program (std::abort) with the place and the broken promise on stderr. For our own bugs
/// only. The tool turns it into exit code 70 (cli/app.h).
[[noreturn]] void invariant_broken(std::string_view expression, std::string_view file, int line);

}  // namespace armcal

/// An assertion that stays on in every build: it guards our own promises, not the caller's input.
#define ARMCAL_INVARIANT(condition)                               \
  do {                                                            \
    if (!(condition)) [[unlikely]]                                \
      ::armcal::invariant_broken(#condition, __FILE__, __LINE__); \
  } while (false)
