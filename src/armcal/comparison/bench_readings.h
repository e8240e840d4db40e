// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "armcal/comparison/bench.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// Postures at which the arm was read.
[[nodiscard]] int count_readings(const std::vector<ObservationGroup>& groups);

/// Readings in two cones of known distance, the whole budget of them: what least squares and the
/// searches without derivatives are compared on. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> cone_and_length(const Bench& bench);

}  // namespace armcal
