// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/simulation/arm_state.h"

namespace armcal {

/// A link as a beam, clamped at its joint: straight to the next one, its mass at one point.
struct LinkBody {
  double mass_kg = 0.0;
  double centre = 0.5;                ///< where the mass is, as a part of the way to the far end
  double bending_per_N_mm2 = 0.0;     ///< 1 / (E I): rad per mm of length and N mm of moment
  double torsion_per_N_mm2 = 0.0;     ///< 1 / (G J)
  double bearing_rad_per_N_mm = 0.0;  ///< tilt of the bearings of its joint
};

/// Links that bend and twist, and bearings that tilt, under the weight of all that is further out.
/// theory/virtual_arm.md eq. (5)-(9)
///
/// Moments about the axis of a joint are held by the hand or by a counterbalance; what they turn is
/// read by the encoder and is no error. Loads are those of the straight arm (deflections are a few
/// tenths of a mm, so what they change in the lever arms is below 1e-3 of them).
struct GravitySag {
  // The same tube and the same joints all along the arm:
  double tube_kg_per_mm = 0.0;
  double joint_kg = 0.0;  ///< housing, bearings and encoder of each joint but the first
  double probe_kg = 0.0;  ///< half way between last joint and tip
  double bending_per_N_mm2 = 0.0;
  double torsion_per_N_mm2 = 0.0;
  double bearing_rad_per_N_mm = 0.0;
  /// Link by link, base to tip (n entries): replaces all of the above. Empty: not said.
  std::vector<LinkBody> links;

  [[nodiscard]] bool is_on() const;
  /// Tube of stiff carbon fibre, 90 mm outside with 4 mm wall (E 140, G 25 GPa, 1.7 g/cm3), joints
  /// of 0.5 kg, a probe of 0.3 kg, bearings of 1e6 N m/rad. An estimate from these; no measured sag
  /// of an arm is published in figures.
  [[nodiscard]] static GravitySag typical();
};

/// The links of an arm as beams. @throws std::invalid_argument where `links` are not n
[[nodiscard]] std::vector<LinkBody> bodies_of(const ArmModel& arm, const GravitySag& sag);

/// Lets the arm hang. @param down  direction of gravity, base frame, of unit length
void add_sag(ArmState& state, const std::vector<LinkBody>& bodies, const Eigen::Vector3d& down);

inline constexpr double kGravity_m_per_s2 = 9.80665;

}  // namespace armcal
