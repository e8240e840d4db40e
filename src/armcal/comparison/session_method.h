// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>

#include "armcal/comparison/method.h"

namespace armcal {

/// Readings that somebody has taken, and what he wants estimated.
struct SessionReadings {
  ArmModel nominal;
  std::span<const ObservationGroup> groups;
  CalibrationOptions calibration;
  std::uint64_t seed = 1;
};

/// A way to calibrate an arm from whatever readings there are.
struct SessionMethod {
  std::string name;
  std::string title;
  double effort = 1.0;
  /// @throws NumericalError
  std::function<FoundArm(const SessionReadings&)> compute;
};

}  // namespace armcal
