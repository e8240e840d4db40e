// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "armcal/observations/observation_group.h"

namespace armcal {

/// Holds out a share of the rows to check the fit with: by whole fixed point or placement where a
/// group has at least four of them (rows of one point share what they do not see) and no length
/// needs them, else row by row. Rows that are held out already stay so; lengths are never chosen.
/// The same seed holds out the same rows.
void hold_out(std::vector<ObservationGroup>& groups, double fraction, std::uint64_t seed);

}  // namespace armcal
