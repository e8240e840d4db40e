// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace armcal {

// A file names others by paths that start in its own folder.

/// What `path`, written in `file`, means.
[[nodiscard]] std::string resolved_path(const std::string& file, const std::string& path);

/// What to write in `file` so that it means `path`.
[[nodiscard]] std::string relative_path(const std::string& file, const std::string& path);

}  // namespace armcal
