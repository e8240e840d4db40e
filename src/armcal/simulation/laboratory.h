// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "armcal/core/random.h"
#include "armcal/geometry/rigid_transform.h"
#include "armcal/observations/observation_group.h"
#include "armcal/simulation/virtual_arm.h"

namespace armcal {

/// What cannot be measured in the laboratory, with the reason: an artefact out of reach, joint
/// limits that leave no posture.
class Impossible : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One posture as it was and as it was shown.
struct TakenReading {
  Eigen::VectorXd encoder_rad;  ///< as shown
  Eigen::Vector3d tip_mm;       ///< where the tip really was, base frame
};

/// A room with one arm in it, a clock and chance: what instruments and artefacts (their own files)
/// take readings with. Every measurement draws from a stream of its own, so that one more does not
/// change the others.
class Laboratory {
 public:
  Laboratory(VirtualArm arm, std::uint64_t seed);

  [[nodiscard]] const VirtualArm& arm() const { return arm_; }
  [[nodiscard]] RandomStream& random() { return random_; }
  /// Begins a measurement: its random numbers depend on its number only.
  void begin(int measurement);

  /// Any posture that the arm can take. @throws Impossible where none is found
  [[nodiscard]] Eigen::VectorXd free_posture();
  /// `count` postures, as different from each other as chance gives, with the tip on a point of
  /// the base frame.
  /// @param what  names the point where it cannot be reached: "seat A"
  /// @throws Impossible
  [[nodiscard]] std::vector<Eigen::VectorXd> postures_with_tip_at(
      const Eigen::Vector3d& point_mm, int count, const std::string& what,
      const Circumstances& circumstances = {});
  /// A point that the arm reaches in many ways.
  [[nodiscard]] Eigen::Vector3d convenient_point();
  /// A place for something of the given size (mm) within reach, turned at random.
  [[nodiscard]] RigidTransform convenient_place(double size_mm);

  /// Takes one reading; the clock goes on by `seconds_per_reading`.
  [[nodiscard]] TakenReading take(const Eigen::VectorXd& encoder_rad,
                                  const Eigen::Vector3d& push = Eigen::Vector3d::Zero());
  /// Normal errors of three coordinates.
  [[nodiscard]] Eigen::Vector3d noise(double u_mm);
  [[nodiscard]] double time_s() const { return time_s_; }

  double seconds_per_reading = 5.0;

 private:
  VirtualArm arm_;
  std::uint64_t seed_;
  RandomStream random_;
  double time_s_ = 0.0;
};

}  // namespace armcal
