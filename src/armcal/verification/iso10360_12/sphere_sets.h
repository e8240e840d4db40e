// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "armcal/verification/probed_sphere.h"
#include "armcal/verification/test_result.h"

namespace armcal::iso10360_12 {

/// Sets of points on a sphere that a test of the standard asks for.
struct AskedSets {
  const char* word;   ///< "position" or "articulation", for the messages of one set
  const char* words;  ///< the same for their number: "sphere position"
  std::size_t sets;
  std::size_t points;  ///< in each
};
inline constexpr AskedSets kTwoPositions{"position", "sphere position", 2, 25};
inline constexpr AskedSets kFiveArticulations{"articulation", "articulation", 5, 5};

/// A sphere through each set, in order. What the sets lack of what is asked for, and what makes
/// them no points of this sphere, is added to the result.
[[nodiscard]] std::vector<ProbedSphere> probe_sets(std::span<const SpherePoints> sets,
                                                   const ReferenceSphere& sphere,
                                                   const AskedSets& asked, TestResult& result);

/// What one set adds to a result.
[[nodiscard]] ResultPart part_of(const SpherePoints& set, const AskedSets& asked, double value_mm);

}  // namespace armcal::iso10360_12
