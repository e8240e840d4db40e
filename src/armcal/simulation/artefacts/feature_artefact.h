// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/simulation/placement.h"

namespace armcal {

/// What ball bars, gauges, plates and lines are to an arm: features with calibrated coordinates
/// that hold the tip, put down in some places.
struct FeatureArtefact {
  Solid solid;
  int placements = 1;
  int postures = 1;   ///< on each feature of each placement
  double u_mm = 0.0;  ///< repeatability of the tip on a feature, each coordinate
  /// Every placement turns the x axis of the solid as far from those before as some tries give.
  bool spread_directions = false;
};

/// Kind artefact: placements NAME-1 .. @throws Impossible
[[nodiscard]] ObservationGroup measure(Laboratory& laboratory, const FeatureArtefact& artefact);

/// `count` features along x in equal steps, the middle at the origin, and the bar that carries
/// them.
/// @param prefix  of their names: "S"
[[nodiscard]] Solid row_of_features(const std::string& name, const std::string& prefix, int count,
                                    double pitch_mm);

}  // namespace armcal
