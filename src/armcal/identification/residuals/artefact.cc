// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/artefact.h"

#include <array>

#include "armcal/identification/residuals/frame_start.h"

namespace armcal {

ArtefactResidual::ArtefactResidual(const ObservationGroup& group, std::vector<int> rows,
                                   Unknowns& unknowns)
    : Residual(group, std::move(rows)),
      point_(group, encoders(group.encoder_rad), unknowns, nuisances_),
      calibrated_mm_(encoders(group.reference_mm)),
      placement_(unknowns.add("placement." + group.place[static_cast<std::size_t>(row(0))],
                              NuisanceKind::frame)) {
  nuisances_.push_back(placement_);
}

std::optional<std::string> ArtefactResidual::start(const ArmAt& nominal, Unknowns& unknowns,
                                                   Eigen::VectorXd& x) const {
  // A bar may turn about itself: its points lie on a line.
  return start_frame(calibrated_mm_, point_.start(nominal, unknowns, x), placement_, unknowns, x,
                     LineIsEnough::yes);
}

void ArtefactResidual::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x,
                            Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  std::array<double, 3 * kObservationsPerBlock> tips;
  point_.fill(at, unknowns, x, first, count, {tips.data(), rows.data, rows.stride});
  const RigidTransform base_from_artefact = unknowns.frame(x, placement_);
  const Eigen::Vector3d pivot = unknowns[placement_].pivot_mm;
  const Eigen::Index column = point_.columns(unknowns);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d feature =
        base_from_artefact * Eigen::Vector3d(calibrated_mm_.col(first + k));
    const Eigen::Matrix3d by_turn = skew(feature - pivot);
    for (Eigen::Index c = 0; c < 3; ++c) {
      double* row = rows.row(3 * k + c);
      for (Eigen::Index j = 0; j < 3; ++j) row[column + j] = by_turn(c, j);
      row[column + 3 + c] = -1.0;
      row[rows.columns] = tips[static_cast<std::size_t>(3 * k + c)] - feature(c);
    }
  }
}

ObservedPlaces ArtefactResidual::places(const ArmAt& at, const Unknowns& unknowns,
                                        const Eigen::VectorXd& x) const {
  return {point_.all(at, unknowns, x), {}};
}

Eigen::MatrixXd ArtefactResidual::J_residual_encoders(const ArmModel& arm, const Unknowns& unknowns,
                                                      const Eigen::VectorXd& x) const {
  return point_.moving(arm, unknowns, x, encoders(group().encoder_rad)).J_encoders;
}

}  // namespace armcal
