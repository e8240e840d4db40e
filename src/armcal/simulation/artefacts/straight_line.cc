// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/straight_line.h"

#include <algorithm>

#include "armcal/simulation/artefacts/feature_artefact.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const StraightLine& line) {
  const double pitch_mm = line.length_mm / std::max(line.positions - 1, 1);
  return {measure(laboratory, FeatureArtefact{.solid = row_of_features(line.name, "P",
                                                                       line.positions, pitch_mm),
                                              .placements = line.directions,
                                              .postures = line.postures,
                                              .u_mm = line.u_mm,
                                              .spread_directions = true})};
}

}  // namespace armcal
