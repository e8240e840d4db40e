// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/population_fit.h"
#include "armcal/comparison/redundant_fit.h"
#include "armcal/core/units.h"

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

SessionMethod search(const std::string& name, const std::string& title, PopulationMethod method,
                     bool redundant) {
  constexpr double kEffort = 100.0;
  // Nobody knows how far an arm is from its drawing: far enough for one that a person put together.
  return {.name = redundant ? name + "-redundant" : name,
          .title = title + (redundant ? ", all parameters" : ""),
          .effort = kEffort,
          .compute = [=](const SessionReadings& readings) {
            return population_fit(readings.nominal, readings.groups,
                                  {.method = method,
                                   .redundant = redundant,
                                   .half_length_mm = 5.0,
                                   .half_angle_rad = radians_from_degrees(1.0),
                                   .seed = readings.seed},
                                  readings.calibration.monitor);
          }};
}

}  // namespace

std::vector<SessionMethod> session_methods() {
  std::vector<SessionMethod> methods = {
      {.name = "nominal",
       .title = "nominal arm",
       .compute =
           [](const SessionReadings& readings) { return FoundArm{.arm = readings.nominal}; }},
      {.name = "session",
       .title = "least squares as the session asks",
       .compute =
           [](const SessionReadings& readings) {
             return found_arm(calibrate(readings.nominal, readings.groups, readings.calibration));
           }},
      least_squares("least-squares", "least squares, geometry", 0, RobustLoss::none),
      least_squares("least-squares-1", "least squares, first harmonics", 1, RobustLoss::none),
      least_squares("least-squares-2", "least squares, two harmonics", 2, RobustLoss::none),
      least_squares("least-squares-robust", "least squares, Huber's loss", 0, RobustLoss::huber),
      {.name = "least-squares-redundant",
       .title = "least squares, all parameters",
       .compute =
           [](const SessionReadings& readings) {
             return redundant_fit(readings.nominal, readings.groups, readings.calibration.monitor);
           }},
      {.name = "least-squares-plain",
       .title = "the same, undamped",
       .compute = [](const SessionReadings& readings) {
         return plain_gauss_newton(readings.nominal, readings.groups, readings.calibration.monitor);
       }}};
  for (const bool redundant : {false, true}) {
    methods.push_back(
        search("annealing", "simulated annealing", PopulationMethod::annealing, redundant));
    methods.push_back(search("genetic", "genetic algorithm", PopulationMethod::genetic, redundant));
    methods.push_back(
        search("swarm", "particle swarm", PopulationMethod::particle_swarm, redundant));
    methods.push_back(search("evolution", "differential evolution",
                             PopulationMethod::differential_evolution, redundant));
  }
  return methods;
}

}  // namespace armcal
