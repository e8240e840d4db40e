// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/identification/calibration.h"
#include "armcal/simulation/laboratory.h"

namespace armcal::validation {

/// An arm, the readings that calibrate it, and what may be expected of the result.
struct Scenario {
  std::string name;
  std::string description;
  ArmModel nominal;
  std::vector<ObservationGroup> (*measure)(Laboratory&) = nullptr;
  CalibrationOptions options;
  /// Half turns by the adjustment of the symmetric-point method instead of the identification.
  bool by_adjustment = false;
  double u_encoder_rad = 0.0;  ///< of the virtual encoders, and told to the identification
  ScaleEccentricity eccentricity;
  double u_held_out_mm = 0.003;  ///< noise of held-out points, each coordinate
  /// False: the model lacks what the arm has. Then only the words of the report are judged.
  bool model_is_complete = true;
  double largest_rms_ratio = 1.10;  ///< of held-out points over the noise floor
};

/// @param examples  folder of the arms that are used
[[nodiscard]] std::vector<Scenario> all_scenarios(const std::string& examples);

}  // namespace armcal::validation
