// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/synthetic_readings.h"

#include <algorithm>
#include <numbers>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/inverse_kinematics.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/observations/empty_group.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/random_geometry.h"

namespace armcal::testing {
namespace {

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

SyntheticReadings::SyntheticReadings(ArmModel truth, std::uint64_t seed, double noise_mm)
    : truth_(std::move(truth)), random_(seed, 77), noise_mm_(noise_mm) {}

ObservationGroup SyntheticReadings::empty(ReferenceKind kind, const std::string& name, int rows) {
  return empty_group(kind, name, rows, truth_.joint_count(), noise_mm_ > 0.0 ? noise_mm_ : 1.0);
}

Eigen::Vector3d SyntheticReadings::noise() { return noise_mm_ * random_normal_vector(random_); }

Eigen::VectorXd SyntheticReadings::posture() {
  return as_vector(random_posture(truth_.joint_count(), random_));
}

Eigen::Vector3d SyntheticReadings::tip(const Eigen::VectorXd& e) const {
  return ForwardKinematics(truth_).tip_in_base(as_span(e));
}

Eigen::Vector3d SyntheticReadings::reachable_point() {
  // Where the middle of some postures is, the arm reaches in many ways.
  return 0.5 * (tip(posture()) + tip(posture()));
}

Eigen::VectorXd SyntheticReadings::posture_with_tip_at(const Eigen::Vector3d& point_mm) {
  const ForwardKinematics kinematics(truth_);
  const Eigen::Vector3d target = point_mm + noise();
  for (;;) {
    const PostureSearch search =
        find_posture(kinematics, target, posture(), {.tolerance_mm = 1e-11});
    if (search.miss_mm < 1e-9) return search.encoder_rad;
  }
}

ObservationGroup SyntheticReadings::reference_points(int count, const std::string& setup) {
  ObservationGroup group = empty(ReferenceKind::reference_points, "points " + setup, count);
  const RigidTransform reference_from_base = random_transform(random_, 1000.0);
  group.reference_mm.resize(3, count);
  group.place.assign(static_cast<std::size_t>(count), setup);
  for (int i = 0; i < count; ++i) {
    group.encoder_rad.col(i) = posture();
    group.reference_mm.col(i) = reference_from_base * tip(group.encoder_rad.col(i)) + noise();
  }
  return group;
}

ObservationGroup SyntheticReadings::reference_poses(int count, const std::string& setup) {
  ObservationGroup group = empty(ReferenceKind::reference_poses, "poses " + setup, count);
  const RigidTransform reference_from_base = random_transform(random_, 1000.0);
  const Eigen::Matrix3d tip_from_target = rotation_from_vector(random_normal_vector(random_));
  group.reference_mm.resize(3, count);
  group.place.assign(static_cast<std::size_t>(count), setup);
  ArmModel arm = truth_;
  arm.tip.roll_pitch_yaw_rad.setZero();
  const ForwardKinematics kinematics(arm);
  for (int i = 0; i < count; ++i) {
    const Eigen::VectorXd e = posture();
    group.encoder_rad.col(i) = e;
    const RigidTransform pose = reference_from_base * kinematics.base_from_tip(as_span(e));
    group.reference_mm.col(i) = pose.translation_mm + noise();
    const Eigen::Vector3d turn = noise() / group.lever_mm;
    group.orientation.push_back(rotation_from_vector(turn) * pose.rotation * tip_from_target);
  }
  return group;
}

ObservationGroup SyntheticReadings::fixed_points(const std::vector<std::string>& names,
                                                 int postures_each) {
  const int rows = postures_each * static_cast<int>(names.size());
  ObservationGroup group = empty(ReferenceKind::fixed_point, "seats", rows);
  int row = 0;
  for (const std::string& name : names) {
    const Eigen::Vector3d point = reachable_point();
    points_.emplace_back(name, point);
    for (int i = 0; i < postures_each; ++i, ++row) {
      group.place.push_back(name);
      group.encoder_rad.col(row) = posture_with_tip_at(point);
    }
  }
  return group;
}

ObservationGroup SyntheticReadings::length(const std::string& from, const std::string& to) {
  const auto at = [&](const std::string& name) {
    return std::find_if(points_.begin(), points_.end(),
                        [&](const auto& each) { return each.first == name; })
        ->second;
  };
  ObservationGroup group = empty(ReferenceKind::length, "length", 1);
  group.encoder_rad.resize(0, 0);
  group.place = {from};
  group.place_to = {to};
  group.value_mm =
      Eigen::VectorXd::Constant(1, (at(from) - at(to)).norm() + noise_mm_ * random_.normal());
  return group;
}

ObservationGroup SyntheticReadings::artefact(int features, int postures_each,
                                             const std::string& placement) {
  ObservationGroup group =
      empty(ReferenceKind::artefact, "plate " + placement, features * postures_each);
  RigidTransform base_from_artefact = random_transform(random_, 0.0);
  base_from_artefact.translation_mm = reachable_point();
  group.reference_mm.resize(3, features * postures_each);
  int row = 0;
  for (int f = 0; f < features; ++f) {
    // Two features are a bar; more are a plate with some relief.
    const Eigen::Vector3d feature(50.0 * f, features == 2 ? 0.0 : 40.0 * (f % 3),
                                  features == 2 ? 0.0 : 10.0 * (f % 2));
    for (int i = 0; i < postures_each; ++i, ++row) {
      group.reference_mm.col(row) = feature;
      group.feature.push_back("S" + std::to_string(f));
      group.place.push_back(placement);
      group.encoder_rad.col(row) = posture_with_tip_at(base_from_artefact * feature);
    }
  }
  return group;
}

ObservationGroup SyntheticReadings::reversals(int count) {
  ObservationGroup group = empty(ReferenceKind::reversal, "half turns", count);
  group.encoder_end_rad = group.encoder_rad;
  group.value_mm.resize(count);
  for (int i = 0; i < count; ++i) {
    // Half turns of the last joint see little of the arm.
    const int joint =
        1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(truth_.joint_count() - 1)));
    group.joint.push_back(joint);
    group.encoder_rad.col(i) = posture();
    group.encoder_end_rad.col(i) = group.encoder_rad.col(i);
    group.encoder_end_rad(joint - 1, i) += std::numbers::pi;
    group.value_mm(i) = (tip(group.encoder_rad.col(i)) - tip(group.encoder_end_rad.col(i))).norm() +
                        noise_mm_ * random_.normal();
  }
  return group;
}

ObservationGroup SyntheticReadings::circle_radii(int count) {
  ObservationGroup group = empty(ReferenceKind::circle_radius, "circles", count);
  group.value_mm.resize(count);
  for (int i = 0; i < count; ++i) {
    const int joint =
        1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(truth_.joint_count())));
    group.joint.push_back(joint);
    const Eigen::VectorXd e = posture();
    group.encoder_rad.col(i) = e;
    const TipLinearisation at = ForwardKinematics(truth_).linearise(as_span(e));
    const Eigen::Vector3d lever = at.tip_mm - at.joint_origins_mm.col(joint - 1);
    group.value_mm(i) = lever.cross(Eigen::Vector3d(at.joint_axes.col(joint - 1))).norm() +
                        noise_mm_ * random_.normal();
  }
  return group;
}

ObservationGroup SyntheticReadings::sphere(int count, double radius_mm, bool known) {
  ObservationGroup group = empty(ReferenceKind::sphere, "ball", count);
  if (known) group.radius_mm = radius_mm;
  group.tip_radius_mm = 3.0;
  const Eigen::Vector3d center = reachable_point();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d outward = random_normal_vector(random_).normalized();
    group.place.emplace_back("ball");
    group.encoder_rad.col(i) = posture_with_tip_at(center + (radius_mm + 3.0) * outward);
  }
  return group;
}

ObservationGroup SyntheticReadings::plane(int count) {
  ObservationGroup group = empty(ReferenceKind::plane, "table", count);
  const Eigen::Vector3d middle = reachable_point();
  const auto [first, second] = perpendicular_pair(random_normal_vector(random_).normalized());
  for (int i = 0; i < count; ++i) {
    group.place.emplace_back("table");
    group.encoder_rad.col(i) = posture_with_tip_at(middle + 100.0 * random_.normal() * first +
                                                   100.0 * random_.normal() * second);
  }
  return group;
}

ArmModel perturbed(const ArmModel& arm, RandomStream& random, double u_mm, double u_rad) {
  const ParameterTable table(arm);
  Eigen::VectorXd values = table.nominal();
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].kind == ParameterKind::beta || table[i].harmonic > 0) continue;
    values(i) += (table[i].unit == ParameterUnit::mm ? u_mm : u_rad) * random.normal();
  }
  return with_parameter_values(arm, values);
}

}  // namespace armcal::testing
