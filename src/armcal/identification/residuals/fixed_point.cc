// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/fixed_point.h"

#include <array>

namespace armcal {

FixedPointResidual::FixedPointResidual(const ObservationGroup& group, std::vector<int> rows,
                                       Unknowns& unknowns)
    : Residual(group, std::move(rows)),
      point_(group, encoders(group.encoder_rad), unknowns, nuisances_),
      center_(unknowns.add("point." + group.place[static_cast<std::size_t>(row(0))],
                           NuisanceKind::point)) {
  nuisances_.push_back(center_);
}

std::optional<std::string> FixedPointResidual::start(const ArmAt& nominal, Unknowns& unknowns,
                                                     Eigen::VectorXd& x) const {
  const Eigen::Matrix3Xd points = point_.start(nominal, unknowns, x);
  if (unknowns[center_].started) return std::nullopt;
  unknowns.set_point(x, center_, points.rowwise().mean());
  unknowns[center_].started = true;
  return std::nullopt;
}

void FixedPointResidual::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x,
                              Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  std::array<double, 3 * kObservationsPerBlock> tips;
  point_.fill(at, unknowns, x, first, count, {tips.data(), rows.data, rows.stride});
  const Eigen::Vector3d center = unknowns.point(x, center_);
  const Eigen::Index column = point_.columns(unknowns);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      double* row = rows.row(3 * k + c);
      row[column + c] = -1.0;
      row[rows.columns] = tips[static_cast<std::size_t>(3 * k + c)] - center(c);
    }
  }
}

ObservedPlaces FixedPointResidual::places(const ArmAt& at, const Unknowns& unknowns,
                                          const Eigen::VectorXd& x) const {
  return {point_.all(at, unknowns, x), {}};
}

Eigen::MatrixXd FixedPointResidual::J_residual_encoders(const ArmModel& arm,
                                                        const Unknowns& unknowns,
                                                        const Eigen::VectorXd& x) const {
  return point_.moving(arm, unknowns, x, encoders(group().encoder_rad)).J_encoders;
}

}  // namespace armcal
