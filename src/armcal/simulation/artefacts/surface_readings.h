// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "armcal/simulation/placement.h"

namespace armcal {

/// Touches a surface in some placements, NAME-1 .., and fills the angles and places of the group:
/// a row for every feature of every placement. The tip is off along the normal by what the surface
/// is uncertain by.
/// @param with_contacts  the surface under its name, its features where the tip is to touch it
/// @throws Impossible
void touch(Laboratory& laboratory, int placements,
           const std::function<Solid(const std::string& name)>& with_contacts, double u_mm,
           ObservationGroup& group);

}  // namespace armcal
