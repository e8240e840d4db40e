// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "armcal/core/progress.h"
#include "armcal/simulation/laboratory.h"
#include "armcal/simulation/virtual_arm.h"

namespace armcal {

/// What every method is given: the same arm, references of the same quality, the same number of
/// readings.
struct Bench {
  VirtualArm arm;
  std::uint64_t seed = 1;
  /// Postures at which the arm may be read; a half turn takes two.
  int readings = 120;
  double u_reference_mm = 0.005;  ///< of a coordinate of a measured or calibrated point
  double u_length_mm = 0.001;     ///< of a calibrated length
  Monitor monitor;

  [[nodiscard]] double u_encoder_rad() const { return arm.errors().encoder_noise.u_reading_rad(); }
  /// A laboratory of its own for one method: what others measure does not change what it finds
  /// there.
  [[nodiscard]] Laboratory laboratory() const {
    Laboratory laboratory(arm, seed);
    laboratory.begin(1);
    return laboratory;
  }
};

}  // namespace armcal
