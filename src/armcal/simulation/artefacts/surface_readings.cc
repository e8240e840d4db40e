// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/surface_readings.h"

#include <fmt/format.h>

#include "armcal/simulation/contact.h"

namespace armcal {

void touch(Laboratory& laboratory, int placements,
           const std::function<Solid(const std::string& name)>& with_contacts, double u_mm,
           ObservationGroup& group) {
  for (int k = 1; k <= placements; ++k) {
    const Solid solid = with_contacts(fmt::format("{}-{}", group.name, k));
    const RigidTransform base_from_solid = place_within_reach(laboratory, solid);
    for (const Feature& feature : solid.features) {
      Feature contact = placed(base_from_solid, feature);
      contact.at_mm += u_mm * laboratory.random().normal() * contact.outward;
      group.encoder_rad.col(static_cast<Eigen::Index>(group.place.size())) =
          take_on(laboratory, contact, fmt::format("{}: {}", solid.name, feature.name)).encoder_rad;
      group.place.push_back(solid.name);
    }
  }
}

}  // namespace armcal
