// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/length.h"

#include <fmt/format.h>

namespace armcal {

LengthResidual::LengthResidual(const ObservationGroup& group, std::vector<int> rows,
                               Unknowns& unknowns)
    : Residual(group, std::move(rows)),
      from_(unknowns.add("point." + group.place[static_cast<std::size_t>(row(0))],
                         NuisanceKind::point)),
      to_(unknowns.add("point." + group.place_to[static_cast<std::size_t>(row(0))],
                       NuisanceKind::point)) {
  nuisances_ = {from_, to_};
}

std::optional<std::string> LengthResidual::start(const ArmAt&, Unknowns& unknowns,
                                                 Eigen::VectorXd& x) const {
  for (const int id : nuisances_) {
    if (!unknowns[id].started) {
      return fmt::format("the length \"{}\" needs {}, which no fixed_point reading gives",
                         group().name, unknowns[id].name);
    }
  }
  if (unknowns.point(x, from_) == unknowns.point(x, to_)) {
    return fmt::format("the length \"{}\" leads from {} to itself", group().name,
                       unknowns[from_].name);
  }
  return std::nullopt;
}

void LengthResidual::fill(const ArmAt&, const Unknowns& unknowns, const Eigen::VectorXd& x,
                          Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  const Eigen::Vector3d between = unknowns.point(x, from_) - unknowns.point(x, to_);
  const double distance = between.norm();
  for (Eigen::Index k = 0; k < count; ++k) {
    double* row = rows.row(k);
    for (Eigen::Index j = 0; j < 3; ++j) {
      row[j] = between(j) / distance;
      row[3 + j] = -row[j];
    }
    row[rows.columns] = distance - group().value_mm(this->row(first + k));
  }
}

Eigen::MatrixXd LengthResidual::J_residual_encoders(const ArmModel&, const Unknowns&,
                                                    const Eigen::VectorXd&) const {
  return Eigen::MatrixXd(count(), 0);
}

}  // namespace armcal
