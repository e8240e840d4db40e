// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/two_seats.h"

#include <fmt/format.h>

#include "armcal/simulation/artefacts/feature_artefact.h"
#include "armcal/simulation/artefacts/seats.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const TwoSeats& bar) {
  std::vector<Feature> seats;
  ObservationGroup lengths = no_lengths(bar.name + "-length");
  for (int k = 1; k <= bar.placements; ++k) {
    Solid solid = row_of_features(fmt::format("{}-{}", bar.name, k), "", 2, bar.length_mm);
    solid.features[0].name = solid.name + "-A";
    solid.features[1].name = solid.name + "-B";
    const RigidTransform base_from_bar = place_within_reach(laboratory, solid);
    for (const Feature& seat : solid.features) seats.push_back(placed(base_from_bar, seat));
    add_length(laboratory, solid.features[0].name, solid.features[1].name, bar.length_mm,
               bar.u_length_mm, lengths);
  }
  return {measure_seats(laboratory, bar.name, seats, bar.postures, bar.u_mm), lengths};
}

}  // namespace armcal
