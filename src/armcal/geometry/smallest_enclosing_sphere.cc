// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/geometry/smallest_enclosing_sphere.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

namespace armcal {
namespace {

using Points = std::span<const Eigen::Vector3d>;

// The smallest sphere through all of one to four points: its centre lies in their flat. Nothing
// where they leave it open (equal, on a line, in a plane); fewer of them then do.
std::optional<Eigen::Vector3d> circumcentre(Points points, const std::vector<int>& chosen) {
  const Eigen::Vector3d origin = points[static_cast<std::size_t>(chosen[0])];
  const auto count = static_cast<Eigen::Index>(chosen.size()) - 1;
  if (count == 0) return origin;
  Eigen::MatrixXd edges(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    edges.col(k) =
        points[static_cast<std::size_t>(chosen[static_cast<std::size_t>(k + 1)])] - origin;
  }
  // |c - p|^2 = |c|^2 for each edge p from the origin: 2 p . c = |p|^2, of least norm.
  const Eigen::VectorXd half_squares = 0.5 * edges.colwise().squaredNorm().transpose();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(edges);
  if (qr.rank() < count) return std::nullopt;
  const Eigen::MatrixXd r = qr.matrixR().topLeftCorner(count, count).triangularView<Eigen::Upper>();
  const Eigen::VectorXd pivoted = qr.colsPermutation().transpose() * half_squares;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  center.head(count) = r.transpose().triangularView<Eigen::Lower>().solve(pivoted);
  return origin + qr.householderQ() * center;
}

struct Farthest {
  int index = 0;
  double distance_mm = -1.0;
};

Farthest farthest(const Eigen::Vector3d& from, Points points) {
  Farthest found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance_mm = (points[i] - from).norm();
    if (distance_mm > found.distance_mm) found = {static_cast<int>(i), distance_mm};
  }
  return found;
}

// The smallest sphere about up to five of the points. The best centre is among the circumcentres
// of all subsets; any centre's farthest point gives a sphere that contains them, so the one of
// least distance is best whatever rounding does to the others.
EnclosingSphere smallest_about_few(Points points, const std::vector<int>& few) {
  EnclosingSphere best;
  best.radius_mm = std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < (1U << few.size()); ++subset) {
    std::vector<int> chosen;
    for (std::size_t i = 0; i < few.size(); ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(few[i]);
    }
    if (chosen.size() > 4) continue;
    const auto center = circumcentre(points, chosen);
    if (!center) continue;
    double radius_mm = 0.0;
    for (const int i : few) {
      radius_mm = std::max(radius_mm, (points[static_cast<std::size_t>(i)] - *center).norm());
    }
    if (radius_mm < best.radius_mm) best = {*center, radius_mm, chosen};
  }
  return best;
}

}  // namespace

EnclosingSphere smallest_enclosing_sphere(std::span<const Eigen::Vector3d> points_mm) {
  if (points_mm.empty()) throw std::invalid_argument("smallest sphere: there are no points");
  for (const Eigen::Vector3d& point : points_mm) {
    if (!point.allFinite()) {
      throw std::invalid_argument("smallest sphere: a coordinate is not a finite number");
    }
  }
  // Near the end a point outside by x enlarges the sphere by as little as x^2 / (2 radius), which
  // rounding hides. So the sphere that leaves the least outside is kept, and the search goes on as
  // long as either grows better.
  EnclosingSphere best;
  best.radius_mm = std::numeric_limits<double>::infinity();
  EnclosingSphere sphere{points_mm.front(), 0.0, {0}};
  for (;;) {
    const Farthest outside = farthest(sphere.center_mm, points_mm);
    const bool is_better = outside.distance_mm < best.radius_mm;
    if (is_better) best = {sphere.center_mm, outside.distance_mm, sphere.support};
    if (outside.distance_mm <= sphere.radius_mm) return best;
    std::vector<int> few = sphere.support;
    few.push_back(outside.index);
    EnclosingSphere next = smallest_about_few(points_mm, few);
    if (next.radius_mm <= sphere.radius_mm && !is_better) return best;
    sphere = std::move(next);
  }
}

}  // namespace armcal
