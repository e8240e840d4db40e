// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/core/progress.h"
#include "armcal/planning/verification/touch_search.h"

namespace armcal {

/// What is to be verified, and with what.
struct VerificationPlanWishes {
  bool iso10360_12 = true;
  bool b89_4_22 = true;
  VerificationRoom room;
  std::optional<double> reach_mm;      ///< of the arm, as its maker states it; else reach_mm(arm)
  double sphere_diameter_mm = 25.0;    ///< of the test sphere
  double tip_diameter_mm = 6.0;        ///< of the ball of the stylus
  std::vector<double> lengths_mm;      ///< of ISO 10360-12, rising; empty: five up to 66 % of reach
  std::array<double, 2> bars_mm = {};  ///< of B89.4.22, short and long; 0: 60 and 120 % of reach
  std::uint64_t seed = 1;
};

/// One point to be taken: a row of the worksheet. What a test does not use is 0 or empty.
struct PlannedTouch {
  std::string position;  ///< "near", "along x"
  int placement = 0;     ///< of a bar, from 1
  int articulation = 0;
  int point = 0;
  double length_mm = 0.0;
  char end = 0;  ///< A or B of a length
  int repeat = 0;
  Touch touch;
  Eigen::VectorXd encoder_rad;
};

/// A sphere as it is put down.
struct PlannedSphere {
  std::string position;
  Eigen::Vector3d centre_mm;
  Eigen::Vector3d pole;  ///< middle of the half that is probed; the stem leads the other way
};

/// A seat for the tip.
struct PlannedSeat {
  std::string zone;  ///< "near", "middle", "far"
  Eigen::Vector3d at_mm;
  Eigen::Vector3d axis;  ///< out of the seat
};

/// A bar or gauge with calibrated lengths from end A.
struct PlannedBar {
  std::string position;
  Eigen::Vector3d from_mm;  ///< end A
  Eigen::Vector3d to_mm;    ///< end B of the longest length
  std::vector<double> lengths_mm;
};

/// One test of a standard, as it is to be carried out.
struct PlannedTest {
  std::string name;    ///< as verification files call it: "probing"
  std::string title;   ///< for people
  std::string covers;  ///< zones, directions, articulations, in words
  bool is_of_iso = false;
  std::vector<PlannedSphere> spheres;
  std::vector<PlannedSeat> seats;
  std::vector<PlannedBar> bars;
  std::vector<PlannedTouch> touches;  ///< in the order of reading
  Eigen::VectorXd joint_coverage;     ///< share of the range of each joint
};

/// Where to put spheres, seats and bars, and how the arm stands at every point.
struct VerificationPlan {
  ArmModel arm;
  VerificationPlanWishes wishes;  ///< with the defaults filled in
  double reach_mm = 0.0;          ///< of which zones and lengths are shares
  std::vector<PlannedTest> tests;
  Eigen::VectorXd joint_coverage;  ///< of all tests together
};

/// Places the artefacts of ISO 10360-12 and ASME B89.4.22 where the arm reaches them, and finds for
/// every point a posture within its limits, clear of bench and column and with the stylus on the
/// free side; postures differ as much as can be. theory/verification_plan.md. The seed decides; a
/// test is planned alike whatever other tests are.
///
/// Counts and patterns are those of the published descriptions of the standards; where these leave
/// something open (where spheres and bars go, which points of a sphere) the choice is ours and the
/// theory page says so.
/// @throws ImpossiblePlan naming every artefact that finds no place, with the reason;
/// std::invalid_argument for diameters and lengths that are none
[[nodiscard]] VerificationPlan plan_verification(const ArmModel& arm,
                                                 const VerificationPlanWishes& wishes,
                                                 const Monitor& monitor = {});

}  // namespace armcal
