// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal {

/// How much of the range of each joint some postures exercise, 0 to 1.
/// theory/verification_plan.md eq. (9)-(10)
///
/// Between two stops less than a turn apart: largest minus smallest reading, as a share of the way
/// from stop to stop. Else the joint goes all round: the turn less the largest gap between
/// neighbouring readings, as a share of the turn.
[[nodiscard]] Eigen::VectorXd joint_coverage(const ArmModel& arm,
                                             const std::vector<Eigen::VectorXd>& postures_rad);

}  // namespace armcal
