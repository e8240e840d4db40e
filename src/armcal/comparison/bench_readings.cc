// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/bench_readings.h"

#include "armcal/simulation/artefacts/two_seats.h"

namespace armcal {

int count_readings(const std::vector<ObservationGroup>& groups) {
  Eigen::Index count = 0;
  for (const ObservationGroup& group : groups)
    count += group.encoder_rad.cols() + group.encoder_end_rad.cols();
  return static_cast<int>(count);
}

std::vector<ObservationGroup> cone_and_length(const Bench& bench) {
  Laboratory laboratory = bench.laboratory();
  return measure(laboratory, TwoSeats{.u_length_mm = bench.u_length_mm,
                                      .postures = bench.readings / 2,
                                      .u_mm = bench.u_reference_mm});
}

}  // namespace armcal
