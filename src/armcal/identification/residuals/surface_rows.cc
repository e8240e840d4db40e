// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/surface_rows.h"

namespace armcal {

PointBlock::PointBlock(const MeasuredPoint& measured, const ArmAt& at, const Unknowns& unknowns,
                       const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index count)
    : columns_(measured.columns(unknowns)),
      points_(static_cast<std::size_t>(3 * count)),
      derivatives_(static_cast<std::size_t>(3 * count * columns_)) {
  measured.fill(at, unknowns, x, first, count, {points_.data(), derivatives_.data(), columns_});
}

void PointBlock::project(Eigen::Index k, const Eigen::Vector3d& direction, double* row) const {
  const double* by_point = derivatives_.data() + 3 * k * columns_;
  for (Eigen::Index i = 0; i < columns_; ++i) {
    row[i] = direction.x() * by_point[i] + direction.y() * by_point[columns_ + i] +
             direction.z() * by_point[2 * columns_ + i];
  }
}

std::vector<Eigen::Vector3d> columns_of(const Eigen::Matrix3Xd& points) {
  std::vector<Eigen::Vector3d> columns;
  for (Eigen::Index i = 0; i < points.cols(); ++i) columns.emplace_back(points.col(i));
  return columns;
}

}  // namespace armcal
