// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/observations/check_split.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "armcal/core/random.h"

namespace armcal {
namespace {

constexpr std::size_t kLeastPlaces = 4;

bool is_grouped(ReferenceKind kind) {
  return kind == ReferenceKind::fixed_point || kind == ReferenceKind::artefact;
}

// Points that a length of the fit ends at: without their readings it could not be used.
std::set<std::string> ends_of_lengths(const std::vector<ObservationGroup>& groups) {
  std::set<std::string> ends;
  for (const ObservationGroup& group : groups) {
    if (group.kind != ReferenceKind::length) continue;
    for (std::size_t row = 0; row < group.lines.size(); ++row) {
      if (group.is_check[row]) continue;
      ends.insert(group.place[row]);
      ends.insert(group.place_to[row]);
    }
  }
  return ends;
}

// Rows that are held out together.
std::vector<std::vector<std::size_t>> units_of(const ObservationGroup& group,
                                               const std::set<std::string>& ends) {
  std::vector<std::vector<std::size_t>> units;
  const bool is_needed =
      group.kind == ReferenceKind::fixed_point &&
      std::any_of(group.place.begin(), group.place.end(),
                  [&](const std::string& place) { return ends.contains(place); });
  if (is_grouped(group.kind) && !is_needed) {
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
  const std::set<std::string> ends = ends_of_lengths(groups);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    ObservationGroup& group = groups[g];
    if (group.kind == ReferenceKind::length) continue;
    std::vector<std::vector<std::size_t>> units = units_of(group, ends);
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
