// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/arm/arm_model.h"

namespace armcal {

// Drawings of typical measuring arms, for scenarios that no file describes.

/// Round numbers near those of Wang et al. 2016, Table 2 read with the model
/// (examples/wang2016/nominal.arm.toml). Six joints without stops: its procedure needs full turns.
[[nodiscard]] ArmModel romer_arm();

/// Proportions of a 2.5 m arm of seven joints, with stops (examples/arms/seven-joint.arm.toml).
[[nodiscard]] ArmModel seven_joint_arm();

}  // namespace armcal
