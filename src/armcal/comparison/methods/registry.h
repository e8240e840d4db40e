// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/comparison/method.h"
#include "armcal/comparison/session_method.h"

namespace armcal {

// One file per family here; a new method is a row in its family.
[[nodiscard]] std::vector<Method> baseline_methods();
[[nodiscard]] std::vector<Method> least_squares_methods();
[[nodiscard]] std::vector<Method> population_methods();

/// Every method, in the order of the table.
[[nodiscard]] std::vector<Method> all_methods();

/// Those that need no reading of their own.
[[nodiscard]] std::vector<SessionMethod> session_methods();

}  // namespace armcal
