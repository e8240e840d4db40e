// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/commands.h"
#include "armcal/cli/plan_commands.h"

namespace armcal::cli {

Command plan_command() {
  Command command;
  command.name = "plan";
  command.brief = "what to measure: readings that determine an arm best, or verify it";
  command.subcommands = {plan_symmetric_point_command(), plan_verification_command()};
  return command;
}

}  // namespace armcal::cli
