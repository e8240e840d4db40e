// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/verification/sphere_test.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// The sphere test on a table of joint angles (with an arm file) or of coordinates (without one).
/// @throws InputError; NumericalError where the points are no sphere
[[nodiscard]] SphereTest run_sphere_test(InputFiles& files, const std::string& readings_path,
                                         const std::optional<std::string>& arm_path,
                                         const SphereTestOptions& options,
                                         const TableOptions& table_options);

}  // namespace armcal
