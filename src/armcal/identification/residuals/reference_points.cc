// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/reference_points.h"

#include <array>

#include "armcal/identification/residuals/frame_start.h"

namespace armcal {

ReferencePointsResidual::ReferencePointsResidual(const ObservationGroup& group,
                                                 std::vector<int> rows, Unknowns& unknowns)
    : Residual(group, std::move(rows)),
      point_(group, encoders(group.encoder_rad), unknowns, nuisances_),
      reference_mm_(encoders(group.reference_mm)),
      setup_(unknowns.add("setup." + group.place[static_cast<std::size_t>(row(0))],
                          NuisanceKind::frame)) {
  nuisances_.push_back(setup_);
}

std::optional<std::string> ReferencePointsResidual::start(const ArmAt& nominal, Unknowns& unknowns,
                                                          Eigen::VectorXd& x) const {
  const Eigen::Matrix3Xd points = point_.start(nominal, unknowns, x);
  return start_frame(points, reference_mm_, setup_, unknowns, x);
}

void ReferencePointsResidual::fill(const ArmAt& at, const Unknowns& unknowns,
                                   const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index count,
                                   const BlockRows& rows) const {
  std::array<double, 3 * kObservationsPerBlock> tips;
  point_.fill(at, unknowns, x, first, count, {tips.data(), rows.data, rows.stride});
  const RigidTransform T = unknowns.frame(x, setup_);
  const Eigen::Matrix3d back = T.rotation.transpose();
  const Eigen::Vector3d pivot = unknowns[setup_].pivot_mm;
  const Eigen::Index column = point_.columns(unknowns);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d tip = Eigen::Map<const Eigen::Vector3d>(tips.data() + 3 * k);
    const Eigen::Vector3d in_reference = T * tip;
    const Eigen::Vector3d r = back * (in_reference - reference_mm_.col(first + k));
    // d(T p) = turn x (T p - pivot) + shift
    const Eigen::Matrix3d by_turn = -(back * skew(in_reference - pivot));
    for (Eigen::Index c = 0; c < 3; ++c) {
      double* row = rows.row(3 * k + c);
      for (Eigen::Index j = 0; j < 3; ++j) {
        row[column + j] = by_turn(c, j);
        row[column + 3 + j] = back(c, j);
      }
      row[rows.columns] = r(c);
    }
  }
}

ObservedPlaces ReferencePointsResidual::places(const ArmAt& at, const Unknowns& unknowns,
                                               const Eigen::VectorXd& x) const {
  return {point_.all(at, unknowns, x), {}};
}

Eigen::MatrixXd ReferencePointsResidual::J_residual_encoders(const ArmModel& arm,
                                                             const Unknowns& unknowns,
                                                             const Eigen::VectorXd& x) const {
  return point_.moving(arm, unknowns, x, encoders(group().encoder_rad)).J_encoders;
}

}  // namespace armcal
