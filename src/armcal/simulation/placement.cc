// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/placement.h"

#include <fmt/format.h>

#include <cmath>

#include "armcal/simulation/contact.h"

namespace armcal {
namespace {

constexpr int kPlacesToTry = 300;
constexpr double kBodyStep_mm = 20.0;

// What is wrong with a place, and how much of it was found to be right before.
struct Fault {
  std::size_t right = 0;
  std::string reason;
};

std::string at(const Eigen::Vector3d& point) {
  return fmt::format("at ({:.1f}, {:.1f}, {:.1f}) mm", point.x(), point.y(), point.z());
}

RigidTransform any_place(Laboratory& laboratory, const Solid& solid) {
  try {
    return laboratory.convenient_place(0.0);
  } catch (const Impossible& impossible) {
    throw Impossible(fmt::format("{} cannot be measured: {}", solid.name, impossible.what()));
  }
}

std::optional<Fault> fault_of(Laboratory& laboratory, const Solid& solid,
                              const RigidTransform& base_from_solid) {
  // What is cheap to know first: most places fail by it.
  for (const Feature& feature : solid.features) {
    const Eigen::Vector3d in_base = base_from_solid * feature.at_mm;
    if (is_beyond_reach(laboratory.arm(), in_base)) {
      return Fault{0, fmt::format("{} {} is beyond the reach of {:.0f} mm", feature.name,
                                  at(in_base), reach_mm(laboratory.arm().truth()))};
    }
  }
  for (const Eigen::Vector3d& point : solid.body_mm) {
    const Eigen::Vector3d in_base = base_from_solid * point;
    if (const auto obstacle = obstruction(laboratory.arm(), in_base)) {
      return Fault{1, fmt::format("its body {} is {}", at(in_base), *obstacle)};
    }
  }
  for (std::size_t i = 0; i < solid.features.size(); ++i) {
    const Feature feature = placed(base_from_solid, solid.features[i]);
    const std::string which = fmt::format("{} {} is ", feature.name, at(feature.at_mm));
    if (const auto obstacle = obstruction(laboratory.arm(), feature.at_mm)) {
      return Fault{2 + i, which + *obstacle};
    }
    if (!is_within_reach(laboratory, feature)) return Fault{2 + i, which + "out of reach"};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Eigen::Vector3d> bar_body(const Eigen::Vector3d& from_mm,
                                      const Eigen::Vector3d& to_mm) {
  const int steps = static_cast<int>(std::ceil((to_mm - from_mm).norm() / kBodyStep_mm));
  std::vector<Eigen::Vector3d> body;
  for (int i = 0; i <= steps; ++i) {
    body.emplace_back(from_mm + (to_mm - from_mm) * (static_cast<double>(i) / std::max(steps, 1)));
  }
  return body;
}

std::vector<Eigen::Vector3d> plate_body(double size_x_mm, double size_y_mm) {
  std::vector<Eigen::Vector3d> body;
  const Eigen::Vector3d half_x(size_x_mm / 2.0, 0.0, 0.0);
  const Eigen::Vector3d half_y(0.0, size_y_mm / 2.0, 0.0);
  for (const Eigen::Vector3d& edge : bar_body(-half_y, half_y)) {
    const auto row = bar_body(edge - half_x, edge + half_x);
    body.insert(body.end(), row.begin(), row.end());
  }
  return body;
}

RigidTransform place_within_reach(Laboratory& laboratory, const Solid& solid) {
  std::optional<Fault> least;
  for (int i = 0; i < kPlacesToTry; ++i) {
    const RigidTransform base_from_solid = any_place(laboratory, solid);
    auto fault = fault_of(laboratory, solid, base_from_solid);
    if (!fault) return base_from_solid;
    if (!least || fault->right > least->right) least = std::move(fault);
  }
  throw Impossible(fmt::format("{} does not fit within reach: even in the best of {} places {}",
                               solid.name, kPlacesToTry, least->reason));
}

Feature placed(const RigidTransform& base_from_solid, const Feature& feature) {
  return {feature.name, base_from_solid * feature.at_mm,
          base_from_solid.rotation * feature.outward};
}

std::optional<std::string> obstruction(const VirtualArm& arm, const Eigen::Vector3d& point_mm) {
  const Eigen::Vector3d p = arm.truth().base_from_first_joint.inverse() * point_mm;
  const Surroundings& around = arm.surroundings();
  if (around.bench_mm && p.z() < *around.bench_mm) {
    return fmt::format("{:.1f} mm below the bench", *around.bench_mm - p.z());
  }
  const double radius = std::hypot(p.x(), p.y());
  if (p.z() < around.column_top_mm && radius < around.column_radius_mm) {
    return fmt::format("inside the column, {:.1f} mm from the first axis", radius);
  }
  return std::nullopt;
}

}  // namespace armcal
