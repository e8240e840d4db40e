// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/cli/command.h"

namespace armcal::cli {

// One file per way to verify an arm.
[[nodiscard]] Command verify_sphere_command();
[[nodiscard]] Command verify_iso10360_12_command();
[[nodiscard]] Command verify_b89_4_22_command();

}  // namespace armcal::cli
