// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "scenario.h"

namespace armcal::validation {

/// What a method says about an arm, in the words that both methods share.
struct Estimate {
  bool ok = false;
  std::string problem;  ///< where not ok
  ArmModel arm;
  std::vector<int> free;       ///< parameter table indices
  Eigen::MatrixXd covariance;  ///< of the free parameters, as the result states it
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  bool says_scatter = false;  ///< the report says that the readings scatter more than stated
};

[[nodiscard]] Estimate estimate(const Scenario& scenario, std::span<const ObservationGroup> groups);

}  // namespace armcal::validation
