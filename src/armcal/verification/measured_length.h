// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armcal/verification/test_result.h"

namespace armcal {

/// One measurement of a calibrated length.
struct MeasuredLength {
  std::string position;        ///< where in the volume, and in which direction, it stood
  double calibrated_mm = 0.0;  ///< at the temperature of the test
  double measured_mm = 0.0;
  int repeat = 0;     ///< from 1; 0: not numbered
  std::string where;  ///< place in the user's file; may be empty
};

/// The error of every length, measured - calibrated. theory/verification.md eq. (4)
[[nodiscard]] std::vector<ResultPart> length_errors(std::span<const MeasuredLength> lengths);

/// What makes lengths wrong rather than inaccurate: not finite, not positive, or off by more than a
/// tenth and 5 mm; with the unit named where the ratio is that of one (10, 25.4, 100, 1000).
[[nodiscard]] std::vector<std::string> problems_of(std::span<const MeasuredLength> lengths);

}  // namespace armcal
