// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/workflow/input_files.h"

namespace armcal {

/// Points of two tables, one of each making a pair.
struct PointPairs {
  std::vector<Eigen::Vector3d> first_mm;
  std::vector<Eigen::Vector3d> second_mm;
  bool by_name = false;  ///< else by the order of the rows
};

/// Reads and pairs two tables of points: by the column `point` where both have one (their orders
/// may differ), else row by row. An entry of `options.map` is for the files that have its column,
/// at least one of them. @throws InputError where numbers or names do not match
[[nodiscard]] PointPairs read_point_pairs(InputFiles& files, const std::string& first_path,
                                          const std::string& second_path,
                                          const TableOptions& options);

}  // namespace armcal
