// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "armcal/core/invariant.h"
#include "armcal/identification/residuals/artefact.h"
#include "armcal/identification/residuals/circle_radius.h"
#include "armcal/identification/residuals/fixed_point.h"
#include "armcal/identification/residuals/length.h"
#include "armcal/identification/residuals/plane_surface.h"
#include "armcal/identification/residuals/reference_points.h"
#include "armcal/identification/residuals/reference_poses.h"
#include "armcal/identification/residuals/residual.h"
#include "armcal/identification/residuals/reversal.h"
#include "armcal/identification/residuals/sphere_surface.h"

namespace armcal {
namespace {

template <class Kind>
std::unique_ptr<Residual> make(const ObservationGroup& group, std::vector<int> rows,
                               Unknowns& unknowns) {
  return std::make_unique<Kind>(group, std::move(rows), unknowns);
}

using Maker = std::unique_ptr<Residual> (*)(const ObservationGroup&, std::vector<int>, Unknowns&);

// A new kind of reference is a line here.
Maker maker_of(ReferenceKind kind) {
  switch (kind) {
    case ReferenceKind::reference_points:
      return make<ReferencePointsResidual>;
    case ReferenceKind::reference_poses:
      return make<ReferencePosesResidual>;
    case ReferenceKind::fixed_point:
      return make<FixedPointResidual>;
    case ReferenceKind::artefact:
      return make<ArtefactResidual>;
    case ReferenceKind::length:
      return make<LengthResidual>;
    case ReferenceKind::reversal:
      return make<ReversalResidual>;
    case ReferenceKind::circle_radius:
      return make<CircleRadiusResidual>;
    case ReferenceKind::sphere:
      return make<SphereResidual>;
    case ReferenceKind::plane:
      return make<PlaneResidual>;
  }
  ARMCAL_INVARIANT(false);
}

}  // namespace

std::vector<std::unique_ptr<Residual>> residuals_of(const ObservationGroup& group, bool check_rows,
                                                    Unknowns& unknowns) {
  // Rows that share their unknowns, in the order in which the file names them first.
  std::vector<std::vector<int>> parts;
  std::map<std::string, std::size_t> part_of;
  for (int row = 0; row < static_cast<int>(group.count()); ++row) {
    const auto at = static_cast<std::size_t>(row);
    if (group.is_check[at] != check_rows) continue;
    std::string key = group.place.empty() ? "" : group.place[at];
    if (!group.place_to.empty()) key += '\n' + group.place_to[at];
    const auto [entry, is_new] = part_of.try_emplace(key, parts.size());
    if (is_new) parts.emplace_back();
    parts[entry->second].push_back(row);
  }
  std::vector<std::unique_ptr<Residual>> residuals;
  for (std::vector<int>& rows : parts) {
    residuals.push_back(maker_of(group.kind)(group, std::move(rows), unknowns));
  }
  return residuals;
}

}  // namespace armcal
