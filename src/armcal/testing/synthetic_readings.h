// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/core/random.h"
#include "armcal/geometry/rigid_transform.h"
#include "armcal/observations/observation_group.h"

namespace armcal::testing {

/// Readings of every kind that a true arm would give, with normal noise of each coordinate or
/// distance.
class SyntheticReadings {
 public:
  SyntheticReadings(ArmModel truth, std::uint64_t seed, double noise_mm);

  [[nodiscard]] ObservationGroup reference_points(int count, const std::string& setup);
  [[nodiscard]] ObservationGroup reference_poses(int count, const std::string& setup);
  /// `postures_each` postures with the tip in each of the named points.
  [[nodiscard]] ObservationGroup fixed_points(const std::vector<std::string>& names,
                                              int postures_each);
  /// Between two fixed points made before.
  [[nodiscard]] ObservationGroup length(const std::string& from, const std::string& to);
  [[nodiscard]] ObservationGroup artefact(int features, int postures_each,
                                          const std::string& placement);
  [[nodiscard]] ObservationGroup reversals(int count);
  [[nodiscard]] ObservationGroup circle_radii(int count);
  [[nodiscard]] ObservationGroup sphere(int count, double radius_mm, bool known);
  [[nodiscard]] ObservationGroup plane(int count);

  [[nodiscard]] const ArmModel& truth() const { return truth_; }
  [[nodiscard]] RandomStream& random() { return random_; }

 private:
  [[nodiscard]] ObservationGroup empty(ReferenceKind kind, const std::string& name, int rows);
  [[nodiscard]] Eigen::Vector3d noise();
  [[nodiscard]] Eigen::VectorXd posture();
  /// Encoder readings with the tip at a point (plus noise).
  [[nodiscard]] Eigen::VectorXd posture_with_tip_at(const Eigen::Vector3d& point_mm);
  [[nodiscard]] Eigen::Vector3d tip(const Eigen::VectorXd& encoder_rad) const;
  /// A point well within reach.
  [[nodiscard]] Eigen::Vector3d reachable_point();

  ArmModel truth_;
  RandomStream random_;
  double noise_mm_;
  std::vector<std::pair<std::string, Eigen::Vector3d>> points_;
};

/// The paper's arm with every length and angle a little wrong.
[[nodiscard]] ArmModel perturbed(const ArmModel& arm, RandomStream& random, double u_mm,
                                 double u_rad);

}  // namespace armcal::testing
