// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <vector>

#include "armcal/report/document.h"

namespace armcal::testing {

struct ToolResult {
  int code = 0;
  std::string out;
  std::string err;

  /// Standard output as JSON; a test failure where it is none.
  [[nodiscard]] Json json() const;
};

/// Runs the tool in this process, as a user would type it (without the program's name).
[[nodiscard]] ToolResult tool(const std::vector<std::string>& arguments, std::stop_token stop = {});

/// Path of a file below examples/.
[[nodiscard]] std::string example(const std::string& path);

}  // namespace armcal::testing
