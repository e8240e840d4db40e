// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/invariant.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace armcal {

void invariant_broken(std::string_view expression, std::string_view file, int line) {
  const std::string text =
      std::string(file) + ":" + std::to_string(line) +
      ": armcal bug: this should always hold: " + std::string(expression) +
      "\n  help: please report it with the command and the files that led here\n";
  std::fputs(text.c_str(), stderr);
  std::abort();
}

}  // namespace armcal
