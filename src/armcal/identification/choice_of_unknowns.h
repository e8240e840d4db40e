// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/identification/calibration.h"
#include "armcal/identification/estimation_problem.h"

namespace armcal {

/// What of the unknowns the readings determine, and what is held instead.
struct ChoiceOfUnknowns {
  std::vector<int> free;  ///< parameter table indices that stay
  std::vector<int>
      held_steps;  ///< nuisance unknowns that are held, places among the unknowns of the problem
  std::vector<UnseenDirection> unseen;
  double condition_number = 1.0;
  std::vector<int> kept;   ///< places among the unknowns of the problem, most wanted first
  Eigen::MatrixXd factor;  ///< of their covariance, rows as `kept`; empty where it cannot be had
};

/// By rank analysis of the triangular factor of the whole Jacobian; columns in order of wish: what
/// observations bring along, then `wanted_order` of the arm.
/// @param r  triangular_factor of the problem in all unknowns
/// @param scale_is_known  false: no reading knows how long a millimetre is, so the longest length
/// is held
[[nodiscard]] ChoiceOfUnknowns choose_unknowns(const Eigen::MatrixXd& r, const Unknowns& unknowns,
                                               const CalibrationOptions& options,
                                               bool scale_is_known = true);

}  // namespace armcal
