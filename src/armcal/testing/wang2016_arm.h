// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal::testing {

// The arm and the readings of the 2016 paper, as in examples/wang2016.

inline ArmModel romer_arm(double a5, double a7, double b3, double b5, double b7, double d7) {
  ArmModel arm;
  arm.name = "ROMER Infinite 2.0";
  arm.joints.resize(6);
  arm.links.resize(5);
  for (int i = 0; i < 5; ++i) {
    arm.links[static_cast<std::size_t>(i)].alpha_rad = (i % 2 == 0 ? 0.5 : -0.5) * std::numbers::pi;
  }
  arm.links[1].b_mm = b3;
  arm.links[3].b_mm = b5;
  arm.links[3].a_mm = a5;
  arm.tip.a_mm = a7;
  arm.tip.b_mm = b7;
  arm.tip.d_mm = d7;
  return arm;
}

inline ArmModel consistent_romer() {
  return romer_arm(78.312, -25.962, 747.489, 531.880, 176.484, 0.0);
}
inline ArmModel nominal_romer() { return romer_arm(80.0, -25.0, 750.0, 530.0, 175.0, 0.0); }
inline ArmModel printed_romer() {
  return romer_arm(78.312, 25.962, 747.489, 531.880, 178.383, 176.484);
}

inline Eigen::VectorXd degrees(std::vector<double> angles) {
  Eigen::VectorXd v =
      Eigen::Map<Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size()));
  return v * std::numbers::pi / 180.0;
}

inline SymmetricReading reversal(std::string name, int joint, Eigen::VectorXd posture,
                                 double distance_mm = 0.0, std::string solves = "",
                                 double u_mm = 0.003) {
  SymmetricReading reading;
  reading.name = std::move(name);
  reading.kind = SymmetricKind::reversal;
  reading.joint = joint;
  reading.posture_rad = posture;
  reading.posture_end_rad = posture;
  reading.posture_end_rad(joint - 1) += std::numbers::pi;
  reading.value = distance_mm;
  reading.u = u_mm;
  reading.reduced = true;
  reading.solves = std::move(solves);
  return reading;
}

inline SymmetricReading circle_radius(std::string name, int joint, Eigen::VectorXd posture,
                                      double radius_mm = 0.0, double u_mm = 0.003) {
  SymmetricReading reading =
      reversal(std::move(name), joint, std::move(posture), radius_mm, "", u_mm);
  reading.kind = SymmetricKind::circle_radius;
  reading.posture_end_rad = reading.posture_rad;
  return reading;
}

/// Table 1, with l_PP3 as printed (104.070) or as meant (104.700).
inline std::vector<SymmetricReading> wang2016_readings(double l_PP3 = 104.700, double R = 178.383) {
  return {reversal("l_PP1", 5, degrees({0, 0, 0, 0, 0, -90}), 352.968, "b7"),
          reversal("l_PP2", 5, degrees({0, 0, 0, 0, 0, 0}), 51.924, "a7"),
          reversal("l_PP3", 3, degrees({0, 0, 0, 0, 0, 0}), l_PP3, "a5"),
          reversal("l_PP4", 3, degrees({0, 0, 0, 90, 0, -90}), 1115.683, "b5"),
          reversal("l_PP5", 1, degrees({0, 90, 0, 90, 180, -90}), 1298.633, "b3"),
          circle_radius("R", 6, degrees({0, 0, 0, 0, 0, 0}), R)};
}

/// Table 2.
inline std::vector<Claim> wang2016_claims() {
  const double u = 0.0005;
  return {{"a5", 78.312, u, {}},  {"a7", 25.962, u, {}},  {"b3", 747.489, u, {}},
          {"b5", 531.880, u, {}}, {"b7", 178.383, u, {}}, {"d7", 176.484, u, {}}};
}

}  // namespace armcal::testing
