// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/arm/arm_model.h"

namespace armcal {

/// Angle of the joint at an encoder reading: theory/kinematics.md eq. (2).
[[nodiscard]] double joint_angle(const Joint& joint, double encoder_rad);

/// Derivative of that angle by the encoder reading; `joint.direction` for an encoder without
/// harmonics.
[[nodiscard]] double joint_angle_slope(const Joint& joint, double encoder_rad);

/// Encoder reading, near `guess_rad`, at which the joint has the given angle.
[[nodiscard]] double encoder_at_joint_angle(const Joint& joint, double angle_rad, double guess_rad);

}  // namespace armcal
