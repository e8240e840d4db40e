// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/ball_bar.h"

#include "armcal/simulation/artefacts/feature_artefact.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const BallBar& bar) {
  FeatureArtefact artefact{.solid = row_of_features(bar.name, "", 2, bar.length_mm),
                           .placements = bar.placements,
                           .postures = bar.postures,
                           .u_mm = bar.u_mm};
  artefact.solid.features[0].name = "A";
  artefact.solid.features[1].name = "B";
  return {measure(laboratory, artefact)};
}

}  // namespace armcal
