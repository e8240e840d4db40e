// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "armcal/core/progress.h"

namespace armcal {

/// Searches without derivatives that the literature of measuring arms uses, by pagmo2 (Biscani,
/// Izzo 2020, doi:10.21105/joss.02338). Each is set as near to its paper as pagmo2 has it; what
/// the papers' abstracts leave open is pagmo2's default.
enum class PopulationMethod {
  /// Gao et al. 2009: annealing whose range shrinks near the optimum and that keeps the best. Here
  /// Corana's annealing (1987), which adapts the range of each coordinate to its share of accepted
  /// moves, from the start value; it cools to a tenth of what one standard uncertainty of one
  /// parameter adds to a chi-squared.
  annealing,
  /// Wang et al. 2008: real-coded adaptive genetic algorithm with arithmetic crossover, Gaussian
  /// mutation and elitism. Here simulated binary crossover (children lie on the line through their
  /// parents, coordinate by coordinate), Gaussian mutation whose width falls in five stages, and
  /// the best of parents and children live on.
  genetic,
  /// Huang et al. 2010: particle swarm with annealing. Here a swarm with constriction for three
  /// quarters of the evaluations, then annealing from its best; the paper lets single particles
  /// climb while it cools.
  particle_swarm,
  /// Storn, Price 1997: differential evolution rand/1/bin with F = 0.7, CR = 0.9.
  differential_evolution,
};
[[nodiscard]] std::string_view to_string(PopulationMethod method);

/// Was armcal built with pagmo2?
[[nodiscard]] bool has_population_search();

struct PopulationSearchOptions {
  std::int64_t evaluations = 20000;  ///< of the objective, at most
  int population = 40;               ///< at least 8; annealing alone walks with one
  std::uint64_t seed = 1;            ///< the same seed finds the same digits
  Monitor monitor;
};

struct PopulationSearch {
  Eigen::VectorXd best;  ///< of all candidates ever tried; the start is the first of them
  double objective = 0.0;
  double objective_at_start = 0.0;
  std::int64_t evaluations = 0;
  /// The best so far, whenever it fell below 0.99 of the last entry; first the start, last the end.
  struct Step {
    std::int64_t evaluations = 0;
    double objective = 0.0;
  };
  std::vector<Step> history;
};

/// Looks for the least value of a function in a box about a start.
/// @param objective    may return infinity, never NaN
/// @param half_widths  of the box, one positive number per coordinate
/// @throws std::invalid_argument for sizes, widths or options that make no search
/// @throws std::runtime_error "built without pagmo2: install libpagmo-dev" where it was
/// @throws Interrupted when the monitor asks to stop
[[nodiscard]] PopulationSearch search_population(
    PopulationMethod method, const std::function<double(const Eigen::VectorXd&)>& objective,
    const Eigen::VectorXd& start, const Eigen::VectorXd& half_widths,
    const PopulationSearchOptions& options);

}  // namespace armcal
