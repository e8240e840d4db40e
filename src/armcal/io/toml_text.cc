// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/toml_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "armcal/io/number_text.h"
#include "armcal/io/toml_value.h"

namespace armcal {

std::string toml_list(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  for (const std::string& text : texts) quoted.push_back(toml_quoted(text));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string toml_degrees(const Eigen::VectorXd& angles_rad) {
  std::vector<std::string> texts;
  for (const double angle : angles_rad) texts.push_back(degrees_text(angle));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string toml_parameter(const std::string& name, double value) {
  const bool angle = is_angle_parameter(name);
  return fmt::format("{}{} = {}", name, angle ? "_deg" : "_mm",
                     angle ? degrees_text(value) : shortest_text(value));
}

bool is_angle_parameter(const std::string& name) {
  constexpr std::array<std::string_view, 5> kAngles = {"zero", "alpha", "beta", "cos", "sin"};
  return std::any_of(kAngles.begin(), kAngles.end(),
                     [&](std::string_view start) { return name.starts_with(start); });
}

}  // namespace armcal
