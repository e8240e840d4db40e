// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/sphere_surface.h"

#include <fmt/format.h>

#include "armcal/geometry/sphere.h"
#include "armcal/identification/residuals/surface_rows.h"

namespace armcal {

SphereResidual::SphereResidual(const ObservationGroup& group, std::vector<int> rows,
                               Unknowns& unknowns)
    : Residual(group, std::move(rows)),
      point_(group, encoders(group.encoder_rad), unknowns, nuisances_) {
  const std::string name = "sphere." + group.place[static_cast<std::size_t>(row(0))];
  center_ = unknowns.add(name, NuisanceKind::point);
  nuisances_.push_back(center_);
  if (!group.radius_mm) {
    radius_ = unknowns.add(name, NuisanceKind::radius);
    nuisances_.push_back(*radius_);
  }
}

std::optional<std::string> SphereResidual::start(const ArmAt& nominal, Unknowns& unknowns,
                                                 Eigen::VectorXd& x) const {
  const Eigen::Matrix3Xd points = point_.start(nominal, unknowns, x);
  if (unknowns[center_].started) return std::nullopt;
  const SphereFit fit = fit_sphere(columns_of(points));
  if (fit.ok()) {
    unknowns.set_point(x, center_, fit.center_mm);
  } else if (group().radius_mm) {
    // On a small ball a wrong arm scatters more than the radius; the middle is near enough.
    unknowns.set_point(x, center_, points.rowwise().mean());
  } else {
    return fmt::format("the sphere {} cannot be placed by its {} points: {}",
                       unknowns[center_].name, points.cols(), explain(fit.status));
  }
  unknowns[center_].started = true;
  if (radius_) {
    unknowns.set_radius(x, *radius_, fit.radius_mm - group().tip_radius_mm);
    unknowns[*radius_].started = true;
  }
  return std::nullopt;
}

void SphereResidual::fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x,
                          Eigen::Index first, Eigen::Index count, const BlockRows& rows) const {
  const PointBlock points(point_, at, unknowns, x, first, count);
  const Eigen::Vector3d center = unknowns.point(x, center_);
  const double radius =
      (radius_ ? unknowns.radius(x, *radius_) : *group().radius_mm) + group().tip_radius_mm;
  const Eigen::Index column = point_.columns(unknowns);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector3d from_center = points.point(k) - center;
    const double distance = from_center.norm();
    const Eigen::Vector3d outward = from_center / distance;
    double* row = rows.row(k);
    points.project(k, outward, row);
    for (Eigen::Index j = 0; j < 3; ++j) row[column + j] = -outward(j);
    if (radius_) row[column + 3] = -1.0;
    row[rows.columns] = distance - radius;
  }
}

ObservedPlaces SphereResidual::places(const ArmAt& at, const Unknowns& unknowns,
                                      const Eigen::VectorXd& x) const {
  ObservedPlaces places{point_.all(at, unknowns, x), {}};
  places.direction =
      (places.point_mm.colwise() - unknowns.point(x, center_)).colwise().normalized();
  return places;
}

Eigen::MatrixXd SphereResidual::J_residual_encoders(const ArmModel& arm, const Unknowns& unknowns,
                                                    const Eigen::VectorXd& x) const {
  const MovingPoints points = point_.moving(arm, unknowns, x, encoders(group().encoder_rad));
  const Eigen::Vector3d center = unknowns.point(x, center_);
  Eigen::MatrixXd J(count(), points.J_encoders.cols());
  for (Eigen::Index i = 0; i < count(); ++i) {
    const Eigen::Vector3d outward = (points.at_mm.col(i) - center).normalized();
    J.row(i) = outward.transpose() * points.J_encoders.middleRows<3>(3 * i);
  }
  return J;
}

}  // namespace armcal
