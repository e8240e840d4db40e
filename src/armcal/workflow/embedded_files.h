// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace armcal {

/// A text file of the repository that is built into the library (cmake/ArmcalEmbed.cmake).
struct EmbeddedFile {
  std::string_view path;  ///< in the repository
  std::string_view text;
};

[[nodiscard]] std::span<const EmbeddedFile> embedded_files();

[[nodiscard]] std::optional<EmbeddedFile> find_embedded_file(std::string_view path);

}  // namespace armcal
