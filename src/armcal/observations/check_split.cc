// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/observations/check_split.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "armcal/core/random.h"

namespace armcal {
namespace {

constexpr std::size_t kLeastPlaces = 4;

bool is_grouped(ReferenceKind kind) {
  return kind == ReferenceKind::fixed_point || kind == ReferenceKind::artefact;
}

// Rows that are held out together.
std::vector<std::vector<std::size_t>> units_of(const ObservationGroup& group) {
  std::vector<std::vector<std::size_t>> units;
  if (is_grouped(group.kind)) {
    std::map<std::string, std::size_t> unit_of;
    for (std::size_t row = 0; row < group.place.size(); ++row) {
      const auto [at, is_new] = unit_of.try_emplace(group.place[row], units.size());
      if (is_new) units.emplace_back();
      units[at->second].push_back(row);
    }
    if (units.size() >= kLeastPlaces) return units;
    units.clear();
  }
  for (std::size_t row = 0; row < group.lines.size(); ++row) units.push_back({row});
  return units;
}

}  // namespace

void hold_out(std::vector<ObservationGroup>& groups, double fraction, std::uint64_t seed) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    ObservationGroup& group = groups[g];
    if (group.kind == ReferenceKind::length) continue;
    std::vector<std::vector<std::size_t>> units = units_of(group);
    RandomStream random(seed, g);
    // The first of a shuffled list (Fisher and Yates).
    const auto wanted =
        static_cast<std::size_t>(std::llround(fraction * static_cast<double>(units.size())));
    for (std::size_t i = 0; i < wanted; ++i) {
      std::swap(units[i], units[i + random.below(units.size() - i)]);
      for (const std::size_t row : units[i]) group.is_check[row] = true;
    }
  }
}

}  // namespace armcal
