// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenario.h"

namespace armcal::validation {

/// What all trials of a scenario share.
struct Plan {
  const Scenario* scenario = nullptr;
  std::uint64_t seed = 1;
  double noise_factor =
      1.0;                ///< how much larger noise really is than stated: 1 but to test the judge
  ArmModel drawing;       ///< nominal, with all parameters that the truth may have
  std::vector<int> free;  ///< what the readings determine; the truth is drawn in these alone
  std::vector<std::string> names;  ///< of what a trial compares: parameters, then coordinates
  std::size_t parameter_count = 0;
  Eigen::MatrixXd postures_rad;  ///< at which tips are predicted
};

/// One simulated calibration, held against its truth.
struct Trial {
  std::string problem;           ///< empty where it ended well
  bool same_unknowns = true;     ///< as planned
  std::vector<double> error, u;  ///< of Plan::names, mm or rad
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  double squares_mm2 = 0.0;        ///< of held-out points, by the calibrated arm
  double squares_floor_mm2 = 0.0;  ///< by the true one
  bool says_scatter = false;
};

/// Finds what the readings of a scenario determine, on an arm with all kinds of errors.
[[nodiscard]] Plan plan_of(const Scenario& scenario, std::uint64_t seed, double noise_factor = 1.0);

/// @param number  from 0; its random numbers depend on the seed and on this alone
[[nodiscard]] Trial run_trial(const Plan& plan, int number);

}  // namespace armcal::validation
