// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/tried_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace armcal {

std::string TriedPlaces::text() const {
  std::vector<std::pair<std::string, long>> sorted(count_.begin(), count_.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& one, const auto& other) { return one.second > other.second; });
  long tried = accepted_;
  std::string reasons;
  for (const auto& [reason, count] : sorted) {
    tried += count;
    reasons += fmt::format(", {} {} {}", count, count == 1 ? "was" : "were", reason);
  }
  return fmt::format("of {} place{} tried{}", tried, tried == 1 ? "" : "s", reasons);
}

}  // namespace armcal
