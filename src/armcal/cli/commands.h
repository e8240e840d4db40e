// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/cli/command.h"

namespace armcal::cli {

// One file per verb. A new verb is a new file here, a line below, and a line in commands.cc.
[[nodiscard]] Command calibrate_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command compare_command();
[[nodiscard]] Command convert_command();
[[nodiscard]] Command demo_command();
[[nodiscard]] Command diff_command();
[[nodiscard]] Command fit_command();
[[nodiscard]] Command fk_command();
[[nodiscard]] Command identifiability_command();
[[nodiscard]] Command plan_command();
[[nodiscard]] Command predict_command();
[[nodiscard]] Command probe_command();
[[nodiscard]] Command register_command();
[[nodiscard]] Command report_command();
[[nodiscard]] Command simulate_command();
[[nodiscard]] Command symmetric_point_command();
[[nodiscard]] Command verify_command();

/// All verbs, in the order of `armcal --help`.
[[nodiscard]] std::vector<Command> all_commands();

}  // namespace armcal::cli
