// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal {

struct UrdfText {
  std::string text;
  /// What a URDF cannot say, in words: harmonics, a limit on one side only.
  std::vector<std::string> lost;
};

/// The arm as a robot description (URDF, docs/files/urdf.md): link_0, joint_1, link_1 .. and, by a
/// fixed joint, the link `tip`. The value of a joint is the reading of its encoder. Metres and
/// radians, with the digits that read back the same.
[[nodiscard]] UrdfText urdf_text(const ArmModel& arm);

}  // namespace armcal
