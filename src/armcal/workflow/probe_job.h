// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/identification/calibration.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// How a new stylus was measured: its ball in one cone or seat, or on a sphere.
struct ProbeRequest {
  std::string arm;
  std::string readings;
  double u_mm = 0.02;
  std::optional<double> sphere_diameter_mm;  ///< on a sphere; else in a cone
  double tip_diameter_mm = 0.0;
};

/// Finds the tip of an arm, all else staying as it is. @throws InputError, NumericalError
[[nodiscard]] Calibration run_probe(InputFiles& files, const ProbeRequest& request,
                                    const TableOptions& options);

}  // namespace armcal
