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
  Eigen::Vector3d tip_mm;       ///< where the tip is for whoever measures it, base frame
  /// By how much tip and encoders do not belong together; zero but for a blunder.
  Eigen::Vector3d blunder_mm = Eigen::Vector3d::Zero();
  Eigen::Matrix3d base_from_last_joint = Eigen::Matrix3d::Identity();  ///< how it was turned

  [[nodiscard]] bool is_blunder() const { return !blunder_mm.isZero(0.0); }
};

/// A reading that is simply wrong, for tests and for the truth that is written beside simulated
/// files.
struct TakenBlunder {
  int measurement = 0;  ///< number given to `begin`
  int reading = 0;      ///< of that measurement, from 0 in the order in which they were taken
  Eigen::Vector3d off_mm = Eigen::Vector3d::Zero();
};

/// A room with one arm in it, a clock and chance: what instruments and artefacts (their own files)
/// take readings with.
///
/// Every measurement draws from streams of its own, so that one more does not change the others:
/// one for what is chosen (postures, places) and what instruments add, one for encoders, one for
/// movements of the foot, one for blunders, so that an error source switched on does not change
/// them either. Only the clock runs through, and with it what drifts.
class Laboratory {
 public:
  Laboratory(VirtualArm arm, std::uint64_t seed);

  [[nodiscard]] const VirtualArm& arm() const { return arm_; }
  /// For what is chosen, and for the noise of instruments.
  [[nodiscard]] RandomStream& random() { return chance_.choice; }
  /// Begins a measurement: its random numbers depend on its number only.
  /// @param measurement  at least 0; 0 is what a new laboratory begins with
  void begin(int measurement);

  /// Any posture that the arm can take: every joint between its stops, or within one turn where it
  /// has none or more than that between them. @throws Impossible where none is found
  [[nodiscard]] Eigen::VectorXd free_posture();
  /// `count` postures with the tip on a point of the base frame, clear of all obstacles: of three
  /// times as many, those that are farthest from each other in the angles of the joints, each
  /// chosen as the farthest from those before it.
  /// @param what  names the point where it cannot be reached: "seat A"
  /// @throws Impossible
  [[nodiscard]] std::vector<Eigen::VectorXd> postures_with_tip_at(
      const Eigen::Vector3d& point_mm, int count, const std::string& what,
      const Circumstances& circumstances = {});
  /// A point that the arm reaches in many ways. @throws Impossible
  [[nodiscard]] Eigen::Vector3d convenient_point();
  /// A place, turned at random, for something flat about the origin of its frame: the arm reaches
  /// the middle and both ends of the size (mm) along x and along y. @throws Impossible
  [[nodiscard]] RigidTransform convenient_place(double size_mm);

  /// Takes one reading of an arm that stands still (its joints locked, or a target on it that is
  /// followed): the tip is where all errors have it. The clock goes on by `seconds_per_reading`.
  [[nodiscard]] TakenReading take(const Eigen::VectorXd& encoder_rad,
                                  const Eigen::Vector3d& push = Eigen::Vector3d::Zero());
  /// Takes one reading with the tip held on a point, by a seat or a surface: the joints are where
  /// all errors of this moment (drift, a foot that moved) have them.
  /// @param near_rad  the posture, as found by `postures_with_tip_at`
  /// @throws Impossible
  [[nodiscard]] TakenReading take_with_tip_at(
      const Eigen::Vector3d& point_mm, const Eigen::VectorXd& near_rad, const std::string& what,
      const Eigen::Vector3d& push = Eigen::Vector3d::Zero());
  /// All blunders so far.
  [[nodiscard]] const std::vector<TakenBlunder>& blunders() const { return blunders_; }
  /// Normal errors of three coordinates.
  [[nodiscard]] Eigen::Vector3d noise(double u_mm);
  [[nodiscard]] double time_s() const { return time_s_; }

  double seconds_per_reading = 5.0;

 private:
  struct Chance {
    Chance(std::uint64_t seed, int measurement);
    RandomStream choice, encoders, foot, blunders;
  };
  [[nodiscard]] Circumstances next_circumstances(const Eigen::Vector3d& push);
  [[nodiscard]] Eigen::Vector3d next_blunder();
  [[nodiscard]] bool reaches(const Eigen::Vector3d& point_mm);
  [[nodiscard]] std::string why_not(const Eigen::Vector3d& point_mm);

  VirtualArm arm_;
  std::uint64_t seed_;
  Chance chance_;
  int measurement_ = 0;
  int reading_ = 0;
  std::vector<TakenBlunder> blunders_;
  double time_s_ = 0.0;
};

}  // namespace armcal
