// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "armcal/verification/test_result.h"

namespace armcal {

/// Half range per axis: (largest - smallest) / 2 of repeated coordinates of one seat, of x, y and z
/// each. A quick form that makers of arms use under a name that ASME B89.4.22 gives to another
/// statistic (b89_4_22/single_point_articulation.h): here it never goes by that name. The largest
/// of the three is reported; parts: x, y, z of the frame of the coordinates. theory/verification.md
/// eq. (10)
[[nodiscard]] TestResult half_range(std::span<const Eigen::Vector3d> points_mm,
                                    const std::string& seat);

}  // namespace armcal
