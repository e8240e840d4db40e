// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// Two seats on a bar of calibrated length, put down in some places.
struct TwoSeats {
  std::string name = "bar";
  double length_mm = 500.0;
  double u_length_mm = 0.001;  ///< of its length, in each placement anew
  int placements = 1;
  int postures = 30;  ///< in each seat of each placement
  double u_mm = 0.005;
};

/// Kinds fixed_point (points NAME-1-A, NAME-1-B, ..) and length (NAME-length). @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory, const TwoSeats& bar);

}  // namespace armcal
