// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace armcal {

/// A text file that is built into the library (cmake/ArmcalEmbed.cmake).
struct EmbeddedFile {
  std::string_view path;  ///< in the repository
  std::string_view text;
};

}  // namespace armcal
