// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "armcal/core/embedded_file.h"

namespace armcal {

/// What reports are made of beside their numbers: layout, style, languages and, where the build had
/// Node, the script.
[[nodiscard]] std::span<const EmbeddedFile> report_assets();

/// The text of an asset by its file name ("report.css"); empty where this build has none.
[[nodiscard]] std::string_view report_asset(std::string_view file_name);

}  // namespace armcal
