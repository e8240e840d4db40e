// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>

#include "armcal/cli/app.h"
#include "armcal/testing/reference_data.h"

namespace armcal::testing {

struct ToolResult {
  int code = 0;
  std::string out;
  std::string err;

  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// Runs the tool in this process, as a user would type it (without the program's name).
inline ToolResult tool(const std::vector<std::string>& arguments, std::stop_token stop = {}) {
  std::ostringstream out;
  std::ostringstream err;
  ToolResult result;
  result.code = cli::run(arguments, {out, err, false, stop});
  result.out = out.str();
  result.err = err.str();
  return result;
}

/// Path of a file below examples/.
inline std::string example(const std::string& path) {
  return (repository() / "examples" / path).string();
}

}  // namespace armcal::testing
