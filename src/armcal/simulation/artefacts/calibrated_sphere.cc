// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/calibrated_sphere.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/artefacts/surface_readings.h"

namespace armcal {
namespace {

// Uniform on the half sphere about +z: equal heights are equal areas.
Eigen::Vector3d random_outward(RandomStream& random) {
  const double height = random.uniform();
  const double azimuth_rad = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double radius = std::sqrt(1.0 - height * height);
  return {radius * std::cos(azimuth_rad), radius * std::sin(azimuth_rad), height};
}

// The stem is on the side of -z.
Solid touched_sphere(Laboratory& laboratory, const CalibratedSphere& sphere,
                     const std::string& name) {
  Solid solid{.name = name};
  const double tip_at_mm = sphere.diameter_mm / 2.0 + sphere.tip_radius_mm;
  for (int i = 1; i <= sphere.points; ++i) {
    const Eigen::Vector3d outward = random_outward(laboratory.random());
    solid.features.push_back({fmt::format("point {}", i), tip_at_mm * outward, outward});
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      solid.body_mm.emplace_back(side * sphere.diameter_mm * Eigen::Vector3d::Unit(axis));
    }
  }
  return solid;
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const CalibratedSphere& sphere) {
  ObservationGroup group =
      empty_group(ReferenceKind::sphere, sphere.name, sphere.placements * sphere.points,
                  laboratory.arm().truth().joint_count(), sphere.u_mm);
  if (sphere.is_known) group.radius_mm = sphere.diameter_mm / 2.0;
  group.tip_radius_mm = sphere.tip_radius_mm;
  const auto with_contacts = [&](const std::string& name) {
    return touched_sphere(laboratory, sphere, name);
  };
  touch(laboratory, sphere.placements, with_contacts, sphere.u_mm, group);
  return {group};
}

}  // namespace armcal
