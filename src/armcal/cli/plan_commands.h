// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/cli/command.h"

namespace armcal::cli {

// The subcommands of `armcal plan`, one file each.
[[nodiscard]] Command plan_symmetric_point_command();
[[nodiscard]] Command plan_verification_command();

}  // namespace armcal::cli
