// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/bench_readings.h"
#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/population_fit.h"
#include "armcal/comparison/redundant_fit.h"

namespace armcal {
namespace {

const char* const kNeedsOfSearches = "two cones of known distance";

using Fit = FoundArm (*)(const ArmModel&, std::span<const ObservationGroup>, const Monitor&);

FoundArm identifiable_fit(const ArmModel& nominal, std::span<const ObservationGroup> groups,
                          const Monitor& monitor) {
  return found_arm(calibrate(nominal, groups, {.monitor = monitor}));
}

// Least squares on what the searches see: uncertain encoders are not weighed.
Method least_squares(const std::string& name, const std::string& title, Fit fit) {
  return {.name = name,
          .title = title,
          .needs = kNeedsOfSearches,
          .take = [=](const Bench& bench) -> TakenReadings {
            std::vector<ObservationGroup> groups = cone_and_length(bench);
            const int count = count_readings(groups);
            return {count, [fit, nominal = bench.arm.nominal(), groups = std::move(groups),
                            monitor = bench.monitor] { return fit(nominal, groups, monitor); }};
          }};
}

// A search in the identifiable parameters, or in all that are written down.
Method search(const std::string& name, const std::string& title, const std::string& reference,
              PopulationMethod method, bool redundant) {
  constexpr double kEffort = 70.0;
  return {.name = redundant ? name + "-redundant" : name,
          .title = title + (redundant ? ", all parameters" : ""),
          .reference = reference,
          .needs = kNeedsOfSearches,
          .effort = kEffort,
          .take = [=](const Bench& bench) -> TakenReadings {
            std::vector<ObservationGroup> groups = cone_and_length(bench);
            const int count = count_readings(groups);
            const PopulationFitOptions options{
                .method = method, .redundant = redundant, .seed = bench.seed};
            return {count, [nominal = bench.arm.nominal(), groups = std::move(groups), options,
                            monitor = bench.monitor] {
                      return population_fit(nominal, groups, options, monitor);
                    }};
          }};
}

}  // namespace

std::vector<Method> population_methods() {
  std::vector<Method> methods = {
      least_squares("same-objective", "least squares, objective of the searches", identifiable_fit),
      least_squares("same-objective-redundant", "the same, all parameters", redundant_fit),
      least_squares("same-objective-plain", "the same, all parameters, undamped",
                    plain_gauss_newton)};
  for (const bool redundant : {false, true}) {
    methods.push_back(search("annealing", "simulated annealing", "Gao et al. 2009",
                             PopulationMethod::annealing, redundant));
    methods.push_back(search("genetic", "real-coded genetic algorithm", "Wang X. et al. 2008",
                             PopulationMethod::genetic, redundant));
    methods.push_back(search("swarm", "particle swarm", "Huang et al. 2010",
                             PopulationMethod::particle_swarm, redundant));
    methods.push_back(search("evolution", "differential evolution", "Storn, Price 1997",
                             PopulationMethod::differential_evolution, redundant));
  }
  return methods;
}

}  // namespace armcal
