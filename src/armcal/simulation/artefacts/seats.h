// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/simulation/placement.h"

namespace armcal {

/// Seats, each of them a fixed point of which nothing is known, in one group: a row for every
/// posture in every seat.
/// @param seats  in the base frame; their names are the points'
/// @throws Impossible
[[nodiscard]] ObservationGroup measure_seats(Laboratory& laboratory, const std::string& name,
                                             const std::vector<Feature>& seats, int postures,
                                             double u_mm);

/// A group of calibrated distances, of the kind length, still without rows.
[[nodiscard]] ObservationGroup no_lengths(const std::string& name);
/// Adds a row: the distance of two points as it was calibrated, with an error of its own.
void add_length(Laboratory& laboratory, const std::string& from, const std::string& to,
                double length_mm, double u_mm, ObservationGroup& lengths);

}  // namespace armcal
