// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/feature_artefact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/contact.h"

namespace armcal {
namespace {

// Cosine of the smallest angle between a direction and those before; a line has no sense.
double likeness(const Eigen::Vector3d& direction, const std::vector<Eigen::Vector3d>& before) {
  double largest = 0.0;
  for (const Eigen::Vector3d& other : before) {
    largest = std::max(largest, std::abs(direction.dot(other)));
  }
  return largest;
}

RigidTransform place_unlike(Laboratory& laboratory, const Solid& solid,
                            const std::vector<Eigen::Vector3d>& before) {
  constexpr int kTries = 5;
  RigidTransform best = place_within_reach(laboratory, solid);
  for (int i = 1; i < kTries; ++i) {
    const RigidTransform other = place_within_reach(laboratory, solid);
    const bool is_better =
        likeness(other.rotation.col(0), before) < likeness(best.rotation.col(0), before);
    if (is_better) best = other;
  }
  return best;
}

}  // namespace

ObservationGroup measure(Laboratory& laboratory, const FeatureArtefact& artefact) {
  const std::string& name = artefact.solid.name;
  const int features = static_cast<int>(artefact.solid.features.size());
  const int rows = artefact.placements * features * artefact.postures;
  ObservationGroup group = empty_group(ReferenceKind::artefact, name, rows,
                                       laboratory.arm().truth().joint_count(), artefact.u_mm);
  group.reference_mm.resize(3, rows);
  std::vector<Eigen::Vector3d> directions;
  Eigen::Index row = 0;
  for (int k = 1; k <= artefact.placements; ++k) {
    Solid solid = artefact.solid;
    solid.name = fmt::format("{}-{}", name, k);
    const RigidTransform base_from_solid = artefact.spread_directions
                                               ? place_unlike(laboratory, solid, directions)
                                               : place_within_reach(laboratory, solid);
    directions.emplace_back(base_from_solid.rotation.col(0));
    for (const Feature& feature : solid.features) {
      group.encoder_rad.middleCols(row, artefact.postures) = take_in_seat(
          laboratory, placed(base_from_solid, feature),
          fmt::format("{}: {}", solid.name, feature.name), artefact.postures, artefact.u_mm);
      for (int i = 0; i < artefact.postures; ++i, ++row) {
        group.reference_mm.col(row) = feature.at_mm;
        group.feature.push_back(feature.name);
        group.place.push_back(solid.name);
      }
    }
  }
  return group;
}

Solid row_of_features(const std::string& name, const std::string& prefix, int count,
                      double pitch_mm) {
  Solid solid{.name = name};
  const double first = -0.5 * (count - 1) * pitch_mm;
  for (int i = 0; i < count; ++i) {
    solid.features.push_back(
        {fmt::format("{}{}", prefix, i + 1), Eigen::Vector3d(first + i * pitch_mm, 0.0, 0.0)});
  }
  solid.body_mm = bar_body(solid.features.front().at_mm, solid.features.back().at_mm);
  return solid;
}

}  // namespace armcal
