// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "armcal/core/embedded_file.h"

namespace armcal {

/// Examples of the repository that the tool can show wherever it is installed.
[[nodiscard]] std::span<const EmbeddedFile> embedded_files();

[[nodiscard]] std::optional<EmbeddedFile> find_embedded_file(std::string_view path);

}  // namespace armcal
