// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <span>
#include <stop_token>
#include <string>

namespace armcal::cli {

/// The outside world of one run of the tool.
struct Console {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;  ///< progress bars and colour are for terminals only
  std::stop_token stop;
};

/// The tool: parses the arguments (without the program's name), runs the command, turns every
/// failure into words on `err` and an exit code. Never throws.
[[nodiscard]] int run(std::span<const std::string> arguments, const Console& console);

/// From here on a broken promise of ours (ARMCAL_INVARIANT, or anything else that aborts) ends this
/// process with exit code 70, after its message. For `main`.
void end_with_exit_code_on_abort();

}  // namespace armcal::cli
