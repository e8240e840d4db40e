// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/report/document.h"
#include "armcal/verification/sphere_test.h"

namespace armcal {

[[nodiscard]] Json json_result(const SphereTest& test, const SphereTestOptions& options);
[[nodiscard]] std::string text_result(const SphereTest& test, const SphereTestOptions& options);

/// The warning that belongs to a test whose readings could not show a wrong arm; empty where they
/// could.
[[nodiscard]] std::string blind_spot_warning(const SphereTest& test);

}  // namespace armcal
