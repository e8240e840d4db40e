// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/assets.h"

namespace armcal {

std::string_view report_asset(std::string_view file_name) {
  for (const EmbeddedFile& file : report_assets()) {
    const std::size_t slash = file.path.rfind('/');
    const std::string_view name =
        slash == std::string_view::npos ? file.path : file.path.substr(slash + 1);
    if (name == file_name) return file.text;
  }
  return {};
}

}  // namespace armcal
