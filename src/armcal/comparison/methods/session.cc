// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/redundant_fit.h"

namespace armcal {
namespace {

SessionMethod least_squares(std::string name, std::string title, int harmonics, RobustLoss loss) {
  return {.name = std::move(name),
          .title = std::move(title),
          .compute = [=](const SessionReadings& readings) {
            CalibrationOptions options = readings.calibration;
            options.harmonics = harmonics;
            options.loss = loss;
            return found_arm(calibrate(readings.nominal, readings.groups, options));
          }};
}

}  // namespace

std::vector<SessionMethod> session_methods() {
  return {
      {.name = "nominal",
       .title = "nominal arm",
       .compute =
           [](const SessionReadings& readings) { return FoundArm{.arm = readings.nominal}; }},
      least_squares("least-squares", "least squares", 0, RobustLoss::none),
      least_squares("least-squares-1", "least squares, first harmonics", 1, RobustLoss::none),
      least_squares("least-squares-2", "least squares, two harmonics", 2, RobustLoss::none),
      least_squares("least-squares-robust", "least squares, Huber's loss", 0, RobustLoss::huber),
      {.name = "least-squares-redundant",
       .title = "least squares, all parameters",
       .compute = [](const SessionReadings& readings) {
         return redundant_fit(readings.nominal, readings.groups, readings.calibration.monitor);
       }}};
}

}  // namespace armcal
