// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/cone_seat.h"

#include <fmt/format.h>

#include "armcal/simulation/artefacts/seats.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const ConeSeat& cone) {
  std::vector<Feature> seats;
  for (int k = 1; k <= cone.seats; ++k) {
    Solid solid{.name = fmt::format("{}-{}", cone.name, k)};
    solid.features.push_back({solid.name, Eigen::Vector3d::Zero()});
    seats.push_back(placed(place_within_reach(laboratory, solid), solid.features[0]));
  }
  return {measure_seats(laboratory, cone.name, seats, cone.postures, cone.u_mm)};
}

}  // namespace armcal
