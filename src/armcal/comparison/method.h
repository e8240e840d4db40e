// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "armcal/comparison/bench.h"
#include "armcal/identification/calibration.h"

namespace armcal {

/// The arm that a method found.
struct FoundArm {
  ArmModel arm;
  std::vector<int> free;  ///< what it estimated, indices into the parameter table of `arm`
  Eigen::VectorXd u;      ///< standard uncertainties of those; empty where it states none
  std::optional<double> condition_number;  ///< of the scaled Jacobian, where there is one
  std::string remark;                      ///< what else a reader should know, a few words
};

/// Readings, and what is left to do with them. Taking them costs the laboratory's time, computing
/// the user's.
struct TakenReadings {
  int count = 0;  ///< postures at which the arm was read
  /// @throws NumericalError with the reason where the readings do not give an arm
  std::function<FoundArm()> compute;
};

/// A way to calibrate an arm, as somebody published it.
struct Method {
  std::string name;       ///< short, for `--methods`
  std::string title;      ///< of its row
  std::string reference;  ///< paper; empty where there is none
  std::string needs;      ///< what must stand in the laboratory
  double effort = 1.0;    ///< rough computing time against least squares, for the progress bar
  /// @throws Impossible where the laboratory cannot do what it asks for
  std::function<TakenReadings(const Bench&)> take;
};

/// @throws NumericalError unless it converged
[[nodiscard]] FoundArm found_arm(const Calibration& calibration);

}  // namespace armcal
