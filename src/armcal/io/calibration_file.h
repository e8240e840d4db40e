// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/core/diagnostics.h"
#include "armcal/io/text_file.h"

namespace armcal {

struct SavedParameter {
  std::string name;
  ParameterUnit unit = ParameterUnit::mm;
  double value = 0.0;
  double u = 0.0;
  bool is_held = false;
};

/// What `armcal calibrate --save` (or --json) wrote, as far as other commands need it.
struct SavedCalibration {
  ArmModel arm;
  std::vector<SavedParameter> parameters;
  std::vector<int> free;       ///< table indices of the parameters that the covariance is of
  Eigen::MatrixXd covariance;  ///< mm, rad
};

/// Is this text a JSON object (and not an arm file)?
[[nodiscard]] bool looks_like_json(const TextFile& file);

/// Problems go to `diagnostics`; with errors nothing is returned.
[[nodiscard]] std::optional<SavedCalibration> read_calibration(const TextFile& file,
                                                               Diagnostics& diagnostics);

}  // namespace armcal
