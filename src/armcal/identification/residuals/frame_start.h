// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/identification/unknowns.h"

namespace armcal {

enum class LineIsEnough { no, yes };

/// Start value of the pose `id` (target_from_source) by registration of paired points, where it has
/// none yet; its pivot becomes the middle of the target points. Points on a line leave a turn about
/// it free: with LineIsEnough::yes any such turn will do.
/// @return in words why the points cannot give one
[[nodiscard]] std::optional<std::string> start_frame(const Eigen::Matrix3Xd& source_mm,
                                                     const Eigen::Matrix3Xd& target_mm, int id,
                                                     Unknowns& unknowns, Eigen::VectorXd& x,
                                                     LineIsEnough line = LineIsEnough::no);

}  // namespace armcal
