// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/iso10360_12/sphere_sets.h"

#include <fmt/format.h>

#include "armcal/verification/as_asked.h"

namespace armcal::iso10360_12 {

std::vector<ProbedSphere> probe_sets(std::span<const SpherePoints> sets,
                                     const ReferenceSphere& sphere, const AskedSets& asked,
                                     TestResult& result) {
  add_unless_as_asked(result.missing, sets.size(), asked.sets, asked.words);
  std::vector<ProbedSphere> probed;
  for (const SpherePoints& set : sets) {
    add_unless_as_asked(result.missing, set.points_mm.size(), asked.points, "point",
                        fmt::format(" at {} {}", asked.word, set.name));
    probed.push_back(probe_sphere(set, sphere, asked.word));
    if (probed.back().problem) result.problems.push_back(*probed.back().problem);
  }
  return probed;
}

ResultPart part_of(const SpherePoints& set, const AskedSets& asked, double value_mm) {
  return {.name = fmt::format("{} {}", asked.word, set.name),
          .value_mm = value_mm,
          .readings = static_cast<int>(set.points_mm.size()),
          .where = set.where};
}

}  // namespace armcal::iso10360_12
