// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "armcal/core/spelling.h"

namespace armcal {

/// Those of a list whose `name` matches one of the patterns, in the order of the list.
/// @throws std::invalid_argument for a pattern that nothing matches
template <class Named>
[[nodiscard]] std::vector<Named> chosen_by_name(std::vector<Named> all,
                                                const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const Named& each : all) names.push_back(each.name);
  for (const std::string& pattern : patterns) {
    const bool known = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return matches_glob(name, pattern);
    });
    if (!known) {
      throw std::invalid_argument("no method matches \"" + pattern +
                                  "\"\n  help: " + did_you_mean(pattern, names));
    }
  }
  std::erase_if(all, [&](const Named& each) {
    return std::none_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
      return matches_glob(each.name, pattern);
    });
  });
  return all;
}

}  // namespace armcal
