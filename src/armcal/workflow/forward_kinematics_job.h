// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "armcal/workflow/input_files.h"

namespace armcal {

/// Tip of an arm for every posture of a table, mm in the base frame. Readings outside the limits of
/// a joint are warned of. @throws InputError, Interrupted
[[nodiscard]] Eigen::Matrix3Xd compute_tips(InputFiles& files, const std::string& arm_path,
                                            const std::string& angles_path,
                                            const TableOptions& options);

/// x_mm,y_mm,z_mm with the fewest digits that read back the same.
[[nodiscard]] std::string tips_csv(const Eigen::Matrix3Xd& tips_mm);

}  // namespace armcal
