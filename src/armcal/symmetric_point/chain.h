// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// One link of the chain: a parameter from one reading, the earlier ones being known.
struct ChainStep {
  std::string parameter;
  std::string reading;
  bool is_angle = false;
  double value = 0.0;  ///< mm or rad
  double u = 0.0;      ///< standard uncertainty: of all readings used so far
};

struct Chain {
  bool complete = false;
  std::string problem;           ///< why it broke off: "l_PP3 does not depend on a5"
  std::vector<ChainStep> steps;  ///< up to there
  ArmModel arm;                  ///< nominal with the recovered values
};

/// The chain of equations of the symmetric-point method for any arm: readings that name the
/// parameter they solve are taken in the order of the file, each solved for its parameter on the
/// arm as known so far (Newton's method from the nominal value, whose sign also chooses between
/// mirror solutions). Readings that solve nothing take no part. A chain whose readings do not tell
/// their parameters apart is broken as well: its result would be an accident of the nominal values.
/// theory/symmetric_point.md eq. (13).
[[nodiscard]] Chain solve_chain(const ArmModel& nominal,
                                std::span<const SymmetricReading> readings);

}  // namespace armcal
