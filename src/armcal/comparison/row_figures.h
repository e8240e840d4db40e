// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "armcal/identification/calibration.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// How an arm does on rows, with frames, seats, spheres and planes placed on these very rows: a
/// place is a convention, the arm is what is judged. Lengths take no part in the placing, they only
/// judge.
struct RowFigures {
  ResidualStatistics residuals;  ///< of all groups together
  /// Rms residual in units of stated uncertainty, 1 as promised; where there is redundancy.
  std::optional<double> over_stated;
};

/// @param held_out  judge on the rows that were held out, else on the others
/// @throws NumericalError where these rows are too few to place what they bring along
[[nodiscard]] RowFigures row_figures(const ArmModel& arm, std::span<const ObservationGroup> groups,
                                     bool held_out);

}  // namespace armcal
