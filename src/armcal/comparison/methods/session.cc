// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "armcal/arm/parameter_table.h"
#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/population_fit.h"
#include "armcal/comparison/redundant_fit.h"

namespace armcal {
namespace {

SessionMethod session_least_squares(std::string name, std::string title, int harmonics,
                                    RobustLoss loss) {
  return {.name = std::move(name),
          .title = std::move(title),
          .compute = [=](const SessionReadings& readings) {
            CalibrationOptions options = readings.calibration;
            options.harmonics = harmonics;
            options.loss = loss;
            return found_arm(calibrate(readings.nominal, readings.groups, options));
          }};
}

// A box about the nominal arm that is sure to hold the answer, twice as wide as least squares found
// it to be: more than anybody could know who has only a search. Candidates cost the more the more
// rows there are.
PopulationFitOptions search_options(const SessionReadings& readings, PopulationMethod method,
                                    bool redundant) {
  const FoundArm found = found_arm(calibrate(readings.nominal, readings.groups, {}));
  const ParameterTable table(readings.nominal);
  const Eigen::VectorXd change = parameter_values(found.arm) - table.nominal();
  PopulationFitOptions options{.method = method, .redundant = redundant, .seed = readings.seed};
  for (const int index : found.free) {
    double& half_width =
        table[index].unit == ParameterUnit::mm ? options.half_length_mm : options.half_angle_rad;
    half_width = std::max(half_width, 2.0 * std::abs(change(index)));
  }
  Eigen::Index rows = 0;
  for (const ObservationGroup& group : readings.groups) rows += group.count();
  constexpr double kRowsInAll = 2e7;
  options.evaluations =
      static_cast<std::int64_t>(std::clamp(kRowsInAll / static_cast<double>(rows), 2e4, 2e5));
  return options;
}

SessionMethod session_search(const std::string& name, const std::string& title,
                             PopulationMethod method, bool redundant) {
  constexpr double kEffort = 100.0;
  return {.name = redundant ? name + "-redundant" : name,
          .title = title + (redundant ? ", all parameters" : ""),
          .effort = kEffort,
          .compute = [=](const SessionReadings& readings) {
            return population_fit(readings.nominal, readings.groups,
                                  search_options(readings, method, redundant),
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
      session_least_squares("least-squares", "least squares, geometry", 0, RobustLoss::none),
      session_least_squares("least-squares-1", "least squares, first harmonics", 1,
                            RobustLoss::none),
      session_least_squares("least-squares-2", "least squares, two harmonics", 2, RobustLoss::none),
      session_least_squares("least-squares-robust", "least squares, Huber's loss", 0,
                            RobustLoss::huber),
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
        session_search("annealing", "simulated annealing", PopulationMethod::annealing, redundant));
    methods.push_back(
        session_search("genetic", "genetic algorithm", PopulationMethod::genetic, redundant));
    methods.push_back(
        session_search("swarm", "particle swarm", PopulationMethod::particle_swarm, redundant));
    methods.push_back(session_search("evolution", "differential evolution",
                                     PopulationMethod::differential_evolution, redundant));
  }
  return methods;
}

}  // namespace armcal
