// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/symmetric_point/adjustment.h"

namespace armcal {

/// A published result held against the readings.
struct ClaimCheck {
  std::string name;
  bool is_angle = false;  ///< rad, else mm
  double claimed = 0.0;
  double value = 0.0;       ///< what the readings give (or, not estimated, what the arm assumes)
  double difference = 0.0;  ///< claimed - value, magnitudes where only the sign differs
  bool sign_differs = false;
  bool agrees = false;
  /// The one reading whose change alone reconciles this claim, with the most others, without
  /// contradicting any other claim or check; and the value that it would need.
  std::optional<std::string> contradicted_by;
  std::optional<double> reconciled_by;
  /// What else has this magnitude, in words: "the reading R", "half of l_PP1", "b7 as adjusted".
  std::vector<std::string> equals;
};

/// Compares claims with the adjusted arm. A claim agrees within four times its standard uncertainty
/// (that of its rounding: claims come from the same readings, whose own uncertainty they share).
/// theory/symmetric_point.md, "Claims".
[[nodiscard]] std::vector<ClaimCheck> check_claims(const ArmModel& nominal,
                                                   std::span<const SymmetricReading> readings,
                                                   const AdjustmentOptions& options,
                                                   const Adjustment& adjustment,
                                                   std::span<const Claim> claims);

}  // namespace armcal
