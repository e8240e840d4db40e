// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/commands.h"

namespace armcal::cli {

std::vector<Command> all_commands() {
  return {demo_command(),
          fk_command(),
          fit_command(),
          register_command(),
          symmetric_point_command(),
          calibrate_command(),
          identifiability_command(),
          predict_command(),
          probe_command(),
          plan_command(),
          verify_command(),
          check_command(),
          compare_command(),
          simulate_command(),
          convert_command(),
          diff_command(),
          report_command()};
}

}  // namespace armcal::cli
