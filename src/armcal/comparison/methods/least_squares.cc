// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/methods/registry.h"
#include "armcal/simulation/instruments/reference_cmm.h"

namespace armcal {
namespace {

int rows_of(const std::vector<ObservationGroup>& groups) {
  Eigen::Index rows = 0;
  for (const ObservationGroup& group : groups) rows += group.encoder_rad.cols();
  return static_cast<int>(rows);
}

// What all methods of this family do with their readings.
TakenReadings to_be_calibrated(const Bench& bench, std::vector<ObservationGroup> groups) {
  CalibrationOptions options;
  options.harmonics = bench.harmonics;
  options.monitor = bench.monitor;
  const int count = rows_of(groups);
  return {count, [nominal = bench.arm.nominal(), groups = std::move(groups), options] {
            return found_arm(calibrate(nominal, groups, options));
          }};
}

TakenReadings take_reference_cmm(const Bench& bench) {
  Laboratory laboratory = bench.laboratory(1);
  return to_be_calibrated(bench, measure(laboratory, ReferenceCmm{.count = bench.readings,
                                                                  .u_mm = bench.u_reference_mm}));
}

TakenReadings take_nothing(const Bench& bench) {
  return {0, [nominal = bench.arm.nominal()] { return FoundArm{.arm = nominal}; }};
}

}  // namespace

std::vector<Method> least_squares_methods() {
  return {{.name = "nominal", .title = "nominal arm", .needs = "nothing", .take = take_nothing},
          {.name = "cmm",
           .title = "least squares, reference CMM",
           .reference = "Wang P., Fei et al. 2007",
           .needs = "a coordinate measuring machine",
           .take = take_reference_cmm}};
}

}  // namespace armcal
