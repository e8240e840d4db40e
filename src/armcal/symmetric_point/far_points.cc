// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/far_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "armcal/geometry/circle.h"
#include "armcal/numerics/median.h"

namespace armcal {
namespace {

// Of repeats scattered normally in space one in 500 would be called far even when there are three
// of them; of ten, practically none.
constexpr double kFar = 8.0;
constexpr double kSigmaOfMedianDeviation = 1.4826;
// What the last digit of a coordinate does is no blunder, however well the others agree.
constexpr double kLeastSpread_mm = 0.002;
constexpr double kChance = 1e-4;
constexpr std::size_t kLeastForArc = 7;

Eigen::Vector3d median_point(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d middle;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> coordinates;
    for (const Eigen::Vector3d& p : points) coordinates.push_back(p(k));
    middle(k) = median(std::move(coordinates));
  }
  return middle;
}

std::vector<double> distances_from_middle(std::span<const Eigen::Vector3d> points) {
  std::vector<double> distances;
  if (points.size() < 2) return distances;  // a single one is its own middle and shows nothing
  const Eigen::Vector3d middle = median_point(points);
  for (const Eigen::Vector3d& p : points) distances.push_back((p - middle).norm());
  return distances;
}

double distance_from(const CircleFit& circle, const Eigen::Vector3d& point) {
  const Eigen::Vector3d lever = point - circle.center_mm;
  const double axial = circle.normal.dot(lever);
  return std::hypot(axial, (lever - axial * circle.normal).norm() - circle.radius_mm);
}

// The worst point of an arc, if the others are a circle so much better without it.
std::optional<FarPoint> worst_of_arc(const std::vector<Eigen::Vector3d>& points) {
  const CircleFit all = fit_circle(points);
  if (points.size() < kLeastForArc || !all.ok()) return std::nullopt;
  Eigen::Index worst = 0;
  all.residuals_mm.cwiseAbs().maxCoeff(&worst);
  std::vector<Eigen::Vector3d> rest = points;
  rest.erase(rest.begin() + worst);
  const CircleFit others = fit_circle(rest);
  if (!others.ok()) return std::nullopt;
  // F test of two residuals more: with two degrees of freedom its probability is a power.
  const double ratio = others.residuals_mm.squaredNorm() / all.residuals_mm.squaredNorm();
  const double chance = std::pow(ratio, static_cast<double>(others.degrees_of_freedom) / 2.0);
  const auto index = static_cast<std::size_t>(worst);
  const FarPoint far{index, distance_from(others, points[index]), others.rms_mm};
  const bool visible = far.distance_mm > kFar * kLeastSpread_mm;
  const bool is_far = visible && chance * static_cast<double>(points.size()) < kChance;
  return is_far ? std::optional(far) : std::nullopt;
}

}  // namespace

std::vector<FarPoint> far_repeats(std::span<const Eigen::Vector3d> end_a,
                                  std::span<const Eigen::Vector3d> end_b) {
  const std::vector<double> a = distances_from_middle(end_a);
  const std::vector<double> b = distances_from_middle(end_b);
  std::vector<double> all = a;
  all.insert(all.end(), b.begin(), b.end());
  if (all.size() < 3) return {};
  // Two pairs: the closer one tells what is usual.
  const bool two_pairs = a.size() == 2 && b.size() == 2;
  const double usual = two_pairs ? std::min(a.front(), b.front()) : median(all);
  const double limit = kFar * std::max(kSigmaOfMedianDeviation * usual, kLeastSpread_mm);
  std::vector<FarPoint> far;
  for (std::size_t i = 0; i < end_a.size() && !a.empty(); ++i) {
    if (a[i] > limit) far.push_back({i, a[i], usual});
  }
  for (std::size_t i = 0; i < end_b.size() && !b.empty(); ++i) {
    if (b[i] > limit) far.push_back({end_a.size() + i, b[i], usual});
  }
  return far;
}

std::vector<FarPoint> far_points_of_arc(std::span<const Eigen::Vector3d> points) {
  std::vector<Eigen::Vector3d> kept(points.begin(), points.end());
  std::vector<std::size_t> original(points.size());
  std::iota(original.begin(), original.end(), std::size_t{0});
  std::vector<FarPoint> far;
  while (far.size() < points.size() / 4) {
    auto worst = worst_of_arc(kept);
    if (!worst) break;
    const auto place = static_cast<std::ptrdiff_t>(worst->index);
    worst->index = original[worst->index];
    far.push_back(*worst);
    kept.erase(kept.begin() + place);
    original.erase(original.begin() + place);
  }
  return far;
}

}  // namespace armcal
