// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "armcal/comparison/true_values.h"
#include "armcal/identification/calibration.h"
#include "armcal/workflow/simulation.h"

namespace armcal {

/// What the truth says of an arm file, on the check postures of a simulation. Tips are compared
/// after the best rigid registration: where the base stands is a convention.
struct TruthCheck {
  double rms_mm = 0.0;  ///< tips by the readings of the encoders, noise and all
  double max_mm = 0.0;
  double floor_mm = 0.0;  ///< the same rms of the true geometry: nothing does better
  double scale = 0.0;     ///< by which its tips must be stretched, minus 1: how wrong its mm are

  [[nodiscard]] double ratio() const { return rms_mm / floor_mm; }
};

/// @param simulation  with check rows (else std::invalid_argument)
[[nodiscard]] TruthCheck check_against_truth(const ArmModel& arm, const Simulation& simulation);

/// True values of the parameters of a calibration, as comparison/true_values.h.
[[nodiscard]] Eigen::VectorXd true_values(const Calibration& calibration, const ArmModel& truth);

/// How many of its free parameters have the true value within their 95 % interval.
[[nodiscard]] IntervalCount count_intervals(const Calibration& calibration, const ArmModel& truth);

}  // namespace armcal
