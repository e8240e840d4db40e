// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/flat_surface.h"

#include <fmt/format.h>

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/artefacts/surface_readings.h"

namespace armcal {
namespace {

// z is out of the surface. The tip's centre stays in one plane, whatever its radius.
Solid touched_surface(Laboratory& laboratory, const FlatSurface& surface, const std::string& name) {
  Solid solid{.name = name, .body_mm = plate_body(surface.size_mm, surface.size_mm)};
  const double half_mm = surface.size_mm / 2.0;
  for (int i = 1; i <= surface.points; ++i) {
    const double x_mm = laboratory.random().uniform(-half_mm, half_mm);
    const double y_mm = laboratory.random().uniform(-half_mm, half_mm);
    solid.features.push_back(
        {fmt::format("point {}", i), Eigen::Vector3d(x_mm, y_mm, 0.0), Eigen::Vector3d::UnitZ()});
  }
  return solid;
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const FlatSurface& surface) {
  ObservationGroup group =
      empty_group(ReferenceKind::plane, surface.name, surface.placements * surface.points,
                  laboratory.arm().truth().joint_count(), surface.u_mm);
  const auto with_contacts = [&](const std::string& name) {
    return touched_surface(laboratory, surface, name);
  };
  touch(laboratory, surface.placements, with_contacts, surface.u_mm, group);
  return {group};
}

}  // namespace armcal
