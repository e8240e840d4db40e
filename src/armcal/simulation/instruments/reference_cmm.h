// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A bridge CMM beside the arm that measures the same points, in its own frame.
struct ReferenceCmm {
  std::string name = "cmm";
  int count = 60;       ///< points
  double u_mm = 0.003;  ///< standard uncertainty of each coordinate
};

/// Kind reference_points. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const ReferenceCmm& cmm);

}  // namespace armcal
