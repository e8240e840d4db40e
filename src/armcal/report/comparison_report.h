// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "armcal/comparison/comparison.h"
#include "armcal/report/document.h"

namespace armcal {

/// Keys: docs/commands/compare.md.
[[nodiscard]] Json json_result(const Comparison& comparison);

/// One table for a terminal.
[[nodiscard]] std::string text_result(const Comparison& comparison);

/// The same table for a page.
[[nodiscard]] std::string markdown_result(const Comparison& comparison);

}  // namespace armcal
