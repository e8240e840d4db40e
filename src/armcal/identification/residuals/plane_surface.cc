// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/plane_surface.h"

#include <fmt/format.h>

#include "armcal/geometry/plane.h"
#include "armcal/identification/residuals/surface_rows.h"

namespace armcal {

PlaneResidual::PlaneResidual(const ObservationGroup& group, std::vector<int> rows,
                             Unknowns& unknowns)
    : Residual(group, std::move(rows)),
      point_(group, encoders(group.encoder_rad), unknowns, nuisances_) {
  plane_ =
      unknowns.add("plane." + group.place[static_cast<std::size_t>(row(0))], NuisanceKind::plane);
  nuisances_.push_back(plane_);
}

std::optional<std::string> PlaneResidual::start(const ArmAt& nominal, Unknowns& unknowns,
                                                Eigen::VectorXd& x) const {
  const Eigen::Matrix3Xd points = point_.start(nominal, unknowns, x);
  if (unknowns[plane_].started) return std::nullopt;
  const PlaneFit fit = fit_plane(columns_of(points));
  if (!fit.ok()) {
    return fmt::format("the plane {} cannot be placed by its {} points: {}", unknowns[plane_].name,
                       points.cols(), explain(fit.status));
  }
  Eigen::Vector4d value;
  value << fit.normal, fit.normal.dot(fit.point_mm);
  unknowns.set_plane(x, plane_, value);
  unknowns[plane_].pivot_mm = fit.point_mm;
  unknowns[plane_].started = true;
  return std::nullopt;
}

void PlaneResidual::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x,
                         Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  const PointBlock points(point_, at, unknowns, x, first, count);
  const Eigen::Vector4d plane = unknowns.plane(x, plane_);
  const Eigen::Vector3d normal = plane.head<3>();
  const auto [first_tilt, second_tilt] = perpendicular_pair(normal);
  const Eigen::Index column = point_.columns(unknowns);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d from_pivot = points.point(k) - unknowns[plane_].pivot_mm;
    double* row = rows.row(k);
    points.project(k, normal, row);
    row[column] = first_tilt.dot(from_pivot);
    row[column + 1] = second_tilt.dot(from_pivot);
    row[column + 2] = -1.0;
    row[rows.columns] = normal.dot(points.point(k)) - plane(3);
  }
}

ObservedPlaces PlaneResidual::places(const ArmAt& at, const Unknowns& unknowns,
                                     const Eigen::VectorXd& x) const {
  const Eigen::Vector3d normal = unknowns.plane(x, plane_).head<3>();
  return {point_.all(at, unknowns, x), normal.replicate(1, count())};
}

Eigen::MatrixXd PlaneResidual::J_residual_encoders(const ArmModel& arm, const Unknowns& unknowns,
                                                   const Eigen::VectorXd& x) const {
  const MovingPoints points = point_.moving(arm, unknowns, x, encoders(group().encoder_rad));
  const Eigen::Vector3d normal = unknowns.plane(x, plane_).head<3>();
  Eigen::MatrixXd J(count(), points.J_encoders.cols());
  for (Eigen::Index i = 0; i < count(); ++i) {
    J.row(i) = normal.transpose() * points.J_encoders.middleRows<3>(3 * i);
  }
  return J;
}

}  // namespace armcal
