// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/observations/observation_group.h"

namespace armcal {

/// A group with room for `count` rows, all to be fitted, that will be written to NAME.csv.
/// @param u_mm  of every row; a noiseless one is stated as 1 um, for weights must be finite
[[nodiscard]] ObservationGroup empty_group(ReferenceKind kind, const std::string& name, int count,
                                           int joint_count, double u_mm);

}  // namespace armcal
