// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/core/progress.h"
#include "armcal/core/units.h"
#include "armcal/observations/symmetric_point_readings.h"
#include "armcal/planning/half_turn_candidates.h"

namespace armcal {

/// What a complete symmetric-point calibration should be like.
struct HalfTurnWishes {
  int readings = 40;
  HalfTurnRoom room;
  int candidates = 4000;  ///< half turns to choose from
  double u_mm = 0.005;    ///< standard uncertainty of a distance, as the reference machine gives it
  double u_encoder_rad = radians_from_arcseconds(2.0);  ///< of one reading of one encoder
  int repeats = 5;  ///< readings of all encoders at each end, averaged
  double least_redundancy = 0.1;
  /// Every error of this size in a single reading is found and named (99.9 %), mm; infinite: no
  /// such wish.
  double largest_unnamed_mm = 1e300;
  int starts = 8;
  std::uint64_t seed = 1;
  int threads = 1;  ///< never changes a digit
};

/// One line of the worksheet.
struct PlannedReading {
  std::string name;
  HalfTurn turn;
  double distance_mm = 0.0;  ///< expected, of the arm as given
  double u_mm = 0.0;         ///< with the share of the encoders
  double redundancy = 0.0;
  double detectable_mm = 0.0;  ///< smallest error that is found (80 %)
  double nameable_mm = 0.0;    ///< smallest error that is found and named (99.9 %)
};

struct PlannedParameter {
  std::string name;
  bool is_angle = false;  ///< rad, else mm
  double u = 0.0;         ///< predicted standard uncertainty
};

/// A procedure of half turns that determines everything an arm's lengths can tell.
struct HalfTurnPlan {
  ArmModel arm;
  HalfTurnWishes wishes;
  int candidates = 0;  ///< distinct half turns that were found
  Rejections rejections;
  std::vector<PlannedReading> readings;  ///< in the order of reading
  std::vector<PlannedParameter> parameters;
  std::vector<int> unknowns;   ///< table indices, as `parameters`
  Eigen::MatrixXd covariance;  ///< of these
  double condition_number = 0.0;
  double length_error_mm =
      0.0;             ///< predicted rms error of a length between two random tip positions
  int joints_set = 0;  ///< between readings, all together

  [[nodiscard]] int rank() const { return static_cast<int>(unknowns.size()); }
  [[nodiscard]] double least_redundancy() const;
  [[nodiscard]] double largest_unnamed_mm() const;
};

/// The half turns of a plan as readings to be taken of all that they determine.
[[nodiscard]] SymmetricPointProcedure procedure_of(const HalfTurnPlan& plan);

/// Chooses half turns (choose_observations), orders them (reading_order, walk_through) and predicts
/// what they will give. theory/complete_symmetric_point.md.
/// @throws ImpossiblePlan where a wish cannot be fulfilled, with the reason
[[nodiscard]] HalfTurnPlan plan_half_turns(const ArmModel& arm, const HalfTurnWishes& wishes,
                                           const Monitor& monitor = {});

/// The half turns as readings of a procedure: reduced, with the distances that this arm has and the
/// uncertainties of the wishes.
[[nodiscard]] std::vector<SymmetricReading> readings_of(const ArmModel& arm,
                                                        const std::vector<HalfTurn>& turns,
                                                        const HalfTurnWishes& wishes);

}  // namespace armcal
