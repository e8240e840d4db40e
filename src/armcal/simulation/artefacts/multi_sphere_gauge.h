// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A long bar with many spheres in a row (Santolaria et al. 2008: 14), read with a self-centring
/// probe in several postures each.
struct MultiSphereGauge {
  std::string name = "gauge";
  int spheres = 14;
  double pitch_mm = 100.0;
  int placements = 3;
  int postures = 3;  ///< on each sphere of each placement
  double u_mm = 0.005;
  /// artefact: coordinates are known, placement by placement. points: every sphere of every
  /// placement is a fixed point, and its distance from the first one is known.
  enum class Form { artefact, points } form = Form::artefact;
  double u_length_mm = 0.001;  ///< points: of each known distance, in each placement anew
};

/// Kind artefact (features S1 ..; placements NAME-1 ..), or fixed_point (points NAME-1-S1 ..) and
/// length (NAME-length). @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const MultiSphereGauge& gauge);

}  // namespace armcal
