// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "armcal/comparison/paper_sphere.h"
#include "armcal/report/document.h"

namespace armcal {

/// Keys: docs/commands/compare.md.
[[nodiscard]] Json json_result(std::span<const NeglectedEffect> effects);

/// One table for a terminal.
[[nodiscard]] std::string text_result(std::span<const NeglectedEffect> effects);

/// The same table for a page.
[[nodiscard]] std::string markdown_result(std::span<const NeglectedEffect> effects);

}  // namespace armcal
