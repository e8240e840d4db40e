// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/embedded_files.h"

namespace armcal {

std::optional<EmbeddedFile> find_embedded_file(std::string_view path) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.path == path) return file;
  }
  return std::nullopt;
}

}  // namespace armcal
