// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/commands.h"
#include "armcal/cli/verify_commands.h"

namespace armcal::cli {

Command verify_command() {
  Command command;
  command.name = "verify";
  command.brief = "judge an arm by measurements of calibrated artefacts";
  command.subcommands = {verify_sphere_command(), verify_iso10360_12_command(),
                         verify_b89_4_22_command()};
  return command;
}

}  // namespace armcal::cli
