// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// How errors of what a procedure assumes leak into what it recovers, to first order:
///   error of recovered parameter = sum over assumed parameters of leakage * (true - assumed
///   value).
struct Leakage {
  std::vector<std::string> recovered;  ///< rows
  std::vector<std::string> assumed;    ///< columns: every other parameter of the arm, table order
  Eigen::MatrixXd table;               ///< mm/mm, mm/rad, rad/mm or rad/rad
};

/// Leakage of the adjustment of all readings, about `arm`. theory/symmetric_point.md eq. (11).
/// @param recovered  table indices of the adjusted parameters
/// @return nothing where the readings do not determine them
[[nodiscard]] std::optional<Leakage> leakage_of_adjustment(
    const ArmModel& arm, std::span<const SymmetricReading> readings,
    const std::vector<int>& recovered);

/// Leakage of the chain of equations, which takes each parameter from one reading: eq. (12).
/// @return nothing where the readings that solve do not tell their parameters apart
[[nodiscard]] std::optional<Leakage> leakage_of_chain(const ArmModel& arm,
                                                      std::span<const SymmetricReading> readings);

}  // namespace armcal
