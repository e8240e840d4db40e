// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/multi_sphere_gauge.h"

#include <fmt/format.h>

#include "armcal/simulation/artefacts/feature_artefact.h"
#include "armcal/simulation/artefacts/seats.h"

namespace armcal {
namespace {

std::vector<ObservationGroup> measure_points(Laboratory& laboratory,
                                             const MultiSphereGauge& gauge) {
  std::vector<Feature> seats;
  ObservationGroup lengths = no_lengths(gauge.name + "-length");
  for (int k = 1; k <= gauge.placements; ++k) {
    const std::string name = fmt::format("{}-{}", gauge.name, k);
    const Solid solid = row_of_features(name, name + "-S", gauge.spheres, gauge.pitch_mm);
    const RigidTransform base_from_gauge = place_within_reach(laboratory, solid);
    const Feature& first = solid.features.front();
    for (const Feature& sphere : solid.features) {
      seats.push_back(placed(base_from_gauge, sphere));
      if (&sphere == &first) continue;
      add_length(laboratory, first.name, sphere.name, (sphere.at_mm - first.at_mm).norm(),
                 gauge.u_length_mm, lengths);
    }
  }
  return {measure_seats(laboratory, gauge.name, seats, gauge.postures, gauge.u_mm), lengths};
}

}  // namespace

std::vector<ObservationGroup> measure(Laboratory& laboratory, const MultiSphereGauge& gauge) {
  if (gauge.form == MultiSphereGauge::Form::points) return measure_points(laboratory, gauge);
  return {measure(laboratory, FeatureArtefact{.solid = row_of_features(
                                                  gauge.name, "S", gauge.spheres, gauge.pitch_mm),
                                              .placements = gauge.placements,
                                              .postures = gauge.postures,
                                              .u_mm = gauge.u_mm})};
}

}  // namespace armcal
