// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/sphere_plate.h"

#include <fmt/format.h>

#include "armcal/simulation/artefacts/feature_artefact.h"

namespace armcal {
namespace {

Solid plate_with_spheres(const SpherePlate& plate) {
  const double size_x_mm = (plate.columns - 1) * plate.pitch_mm;
  const double size_y_mm = (plate.rows - 1) * plate.pitch_mm;
  Solid solid{.name = plate.name, .body_mm = plate_body(size_x_mm, size_y_mm)};
  for (int row = 0; row < plate.rows; ++row) {
    for (int column = 0; column < plate.columns; ++column) {
      const Eigen::Vector3d at_mm(column * plate.pitch_mm - size_x_mm / 2.0,
                                  row * plate.pitch_mm - size_y_mm / 2.0, 0.0);
      solid.features.push_back({fmt::format("S{}", solid.features.size() + 1), at_mm});
    }
  }
  return solid;
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const SpherePlate& plate) {
  return {measure(laboratory, FeatureArtefact{.solid = plate_with_spheres(plate),
                                              .placements = plate.placements,
                                              .postures = plate.postures,
                                              .u_mm = plate.u_mm})};
}

}  // namespace armcal
