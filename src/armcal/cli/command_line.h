// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/cli/command.h"

namespace armcal::cli {

/// What a command line asks for.
struct ParsedCommandLine {
  const Command* command = nullptr;  ///< to run
  std::string full_name;             ///< "armcal fit"
  std::string help;                  ///< to print instead, where asked for
  std::string error;                 ///< what is wrong with the line, with its remedy
};

/// Takes a command line apart and fills the targets of the chosen command's arguments.
/// @param root  the tool itself, whose subcommands are the verbs; its arguments belong to every
/// verb
[[nodiscard]] ParsedCommandLine parse_command_line(const Command& root,
                                                   std::span<const std::string> arguments);

}  // namespace armcal::cli
