// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal {

/// An arm as text for a program that has no use for our files.
struct FirmwareText {
  std::string text;
  std::vector<std::string> lost;  ///< what the text does not say, in words
};

/// A C99 header that stands alone (docs/files/firmware.md): the parameters as constants, mm and
/// rad, and `armcal_tip`, which computes the tip from encoder readings, harmonics included, to 1e-9
/// mm of ForwardKinematics. The include guard is made from the arm's name.
[[nodiscard]] FirmwareText c_header_text(const ArmModel& arm);

/// Two lines of CSV: names with units, and values (mm, rad) of all parameters in the order of
/// ParameterTable.
[[nodiscard]] FirmwareText csv_line_text(const ArmModel& arm);

}  // namespace armcal
