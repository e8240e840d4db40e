// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/tool.h"

#include <sstream>

#include "armcal/cli/app.h"
#include "armcal/testing/reference_data.h"

namespace armcal::testing {

Json ToolResult::json() const {
  Json document = Json::parse(out, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << "no JSON: " << out;
  return document;
}

ToolResult tool(const std::vector<std::string>& arguments, std::stop_token stop) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = cli::run(arguments, {out, err, false, std::move(stop)});
  return {code, out.str(), err.str()};
}

std::string example(const std::string& path) { return (repository() / "examples" / path).string(); }

}  // namespace armcal::testing
