// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/planning/verification_plan.h"

namespace armcal {

/// A drawing of a plan as SVG: for each standard the arm from above (along its first axis) and from
/// the side, with the zones of its reach as rings, column, bench and measuring volume, and the
/// spheres, seats and bars that are put down, each with its label. To scale. Kinds differ by shape
/// and stroke and not by colour; the paper is drawn, light or dark as the reader prefers.
[[nodiscard]] std::string verification_picture(const VerificationPlan& plan);

}  // namespace armcal
