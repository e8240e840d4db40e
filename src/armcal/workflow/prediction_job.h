// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armcal/io/calibration_file.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// Tips with their standard uncertainties, columns by posture.
struct PredictedTips {
  Eigen::Matrix3Xd tips_mm;
  Eigen::Matrix3Xd u_mm;  ///< of x, y and z each
};

/// @throws InputError; also where the file is an arm without covariance
[[nodiscard]] PredictedTips predict_tips(InputFiles& files, const std::string& calibration_path,
                                         const std::string& angles_path,
                                         const TableOptions& options);

/// `x_mm,y_mm,z_mm,u_x_mm,u_y_mm,u_z_mm`, one row each.
[[nodiscard]] std::string predicted_csv(const PredictedTips& predicted);

/// @throws InputError
[[nodiscard]] SavedCalibration load_calibration(InputFiles& files, const std::string& path);

/// A parameter in two calibrations.
struct ParameterChange {
  std::string name;
  ParameterUnit unit = ParameterUnit::mm;
  double before = 0.0;
  double after = 0.0;
  double u = 0.0;  ///< of the difference, both calibrations being independent
  /// after - before in units of u; 0 where both hold the parameter at the same value
  double ratio = 0.0;
  bool held_in_one =
      false;  ///< estimated in one of them only: the difference is one of convention, too
};

/// @throws InputError where the arms do not have the same parameters
[[nodiscard]] std::vector<ParameterChange> changes_between(InputFiles& files,
                                                           const std::string& before,
                                                           const std::string& after);

}  // namespace armcal
