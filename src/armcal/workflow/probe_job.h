// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/identification/stylus.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// How a new stylus was measured: its ball in one cone or seat, or on a sphere.
struct ProbeRequest {
  std::string arm;
  std::string readings;
  double u_mm = 0.02;
  double u_encoder_rad = 0.0;
  std::optional<double> sphere_diameter_mm;  ///< on a sphere; else in a cone
  double tip_diameter_mm = 0.0;
};

/// Fewest readings that are taken: some more than there are unknowns (the tip and the place of the
/// seat or sphere), so that they can contradict each other; and how many to take.
inline constexpr int kLeastInSeat = 5;
inline constexpr int kAdvisedInSeat = 10;
inline constexpr int kLeastOnSphere = 9;
inline constexpr int kAdvisedOnSphere = 25;

/// Finds the tip of an arm, all else staying as it is. Warns of few readings and of a coordinate
/// whose direction hardly swings.
/// @throws InputError, also for too few readings; NumericalError where a coordinate of the tip is
/// not determined, by name
[[nodiscard]] StylusQualification run_probe(InputFiles& files, const ProbeRequest& request,
                                            const TableOptions& options);

}  // namespace armcal
