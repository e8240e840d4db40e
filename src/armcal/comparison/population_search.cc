// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/population_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "armcal/core/random.h"

#ifdef ARMCAL_HAS_PAGMO
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#endif

namespace armcal {

std::string_view to_string(PopulationMethod method) {
  switch (method) {
    case PopulationMethod::annealing:
      return "simulated annealing";
    case PopulationMethod::genetic:
      return "genetic algorithm";
    case PopulationMethod::particle_swarm:
      return "particle swarm";
    case PopulationMethod::differential_evolution:
      return "differential evolution";
  }
  return "unknown";
}

#ifndef ARMCAL_HAS_PAGMO

bool has_population_search() { return false; }

PopulationSearch search_population(PopulationMethod,
                                   const std::function<double(const Eigen::VectorXd&)>&,
                                   const Eigen::VectorXd&, const Eigen::VectorXd&,
                                   const PopulationSearchOptions&) {
  throw std::runtime_error("built without pagmo2: install libpagmo-dev");
}

#else

bool has_population_search() { return true; }

namespace {

using Objective = std::function<double(const Eigen::VectorXd&)>;

constexpr int kLeastPopulation = 8;  // of pagmo2's methods with their defaults
constexpr std::int64_t kReportEvery = 256;

/// Counts, remembers the best and tells the listener: what the methods themselves differ in.
class Search {
 public:
  Search(PopulationMethod method, const Objective& objective, const Eigen::VectorXd& start,
         const Eigen::VectorXd& half_widths, const PopulationSearchOptions& options)
      : method_(method),
        objective_(objective),
        start_(start),
        half_widths_(half_widths),
        options_(options),
        candidate_(start) {}

  /// @param place  in the box, each coordinate from -1 to 1
  double evaluate(const std::vector<double>& place) {
    if (result_.evaluations % kReportEvery == 0) {
      options_.monitor.report(to_string(method_), static_cast<double>(result_.evaluations) /
                                                      static_cast<double>(options_.evaluations));
    }
    for (Eigen::Index i = 0; i < start_.size(); ++i) {
      candidate_(i) = start_(i) + half_widths_(i) * place[static_cast<std::size_t>(i)];
    }
    const double value = objective_(candidate_);
    if (result_.evaluations++ == 0) result_.objective_at_start = value;
    if (result_.evaluations == 1 || value < result_.objective) {
      result_.best = candidate_;
      result_.objective = value;
      best_place_ = place;
      if (result_.history.empty() || value < 0.99 * result_.history.back().objective) {
        result_.history.push_back({result_.evaluations, value});
      }
    }
    return value;
  }

  [[nodiscard]] const std::vector<double>& best_place() const { return best_place_; }
  [[nodiscard]] const PopulationSearch& result() const { return result_; }
  [[nodiscard]] std::int64_t left() const { return options_.evaluations - result_.evaluations; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(start_.size()); }

  [[nodiscard]] PopulationSearch finish() {
    result_.history.push_back({result_.evaluations, result_.objective});
    return std::move(result_);
  }

 private:
  PopulationMethod method_;
  const Objective& objective_;
  const Eigen::VectorXd& start_;
  const Eigen::VectorXd& half_widths_;
  const PopulationSearchOptions& options_;
  Eigen::VectorXd candidate_;
  std::vector<double> best_place_;
  PopulationSearch result_;
};

/// What pagmo2 wants of a problem; it copies it, the search stays one.
struct BoxProblem {
  Search* search = nullptr;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& place) const {
    return {search->evaluate(place)};
  }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const std::size_t size = search == nullptr ? 1 : search->size();
    return {pagmo::vector_double(size, -1.0), pagmo::vector_double(size, 1.0)};
  }
};

// Generations that the evaluations left over allow.
unsigned generations(const Search& search, int population, double share = 1.0) {
  const double wanted = share * static_cast<double>(search.left()) / population;
  return static_cast<unsigned>(std::max(1.0, std::floor(wanted)));
}

// The start and places spread over the box.
pagmo::population first_population(Search& search, int size, RandomStream& random) {
  pagmo::population population(pagmo::problem(BoxProblem{&search}), 0,
                               static_cast<unsigned>(random.bits()));
  std::vector<double> place(search.size(), 0.0);
  for (int i = 0; i < size; ++i) {
    population.push_back(place);
    for (double& coordinate : place) coordinate = random.uniform(-1.0, 1.0);
  }
  return population;
}

// Walks from the best place so far. A temperature is the deterioration that is accepted in 37 of
// 100 cases: cooling goes on to a tenth of what one standard uncertainty of one parameter costs.
void anneal(Search& search, unsigned seed, double start_range) {
  constexpr unsigned kMovesPerRange = 10;
  constexpr double kCold = 0.1;
  const std::vector<double> from = search.best_place();
  pagmo::population walker(pagmo::problem(BoxProblem{&search}), 0, seed);
  const double value = search.result().objective;
  walker.push_back(from, {value});
  const auto per_temperature = static_cast<double>(kMovesPerRange * search.size());
  const double temperatures = std::floor(static_cast<double>(search.left()) / per_temperature);
  if (temperatures < 1.0) return;
  const double hot = std::clamp(0.1 * value, 10.0 * kCold, 1e300);
  const pagmo::simulated_annealing method(hot, kCold, static_cast<unsigned>(temperatures), 1,
                                          kMovesPerRange, start_range, seed);
  static_cast<void>(method.evolve(walker));
}

void breed(Search& search, int size, RandomStream& random) {
  constexpr int kStages = 5;
  size -= size % 2;  // parents come in pairs
  pagmo::population population = first_population(search, size, random);
  double width = 0.1;  // of the box
  for (int stage = 0; stage < kStages; ++stage, width *= 0.2) {
    const unsigned count = generations(search, size, 1.0 / (kStages - stage));
    if (search.left() < size) return;
    const pagmo::sga method(count, 0.9, 2.0, 1.0 / static_cast<double>(search.size()), width, 2,
                            "sbx", "gaussian", "tournament", static_cast<unsigned>(random.bits()));
    population = method.evolve(population);
  }
}

void swarm(Search& search, int size, RandomStream& random) {
  const pagmo::population population = first_population(search, size, random);
  const pagmo::pso method(generations(search, size, 0.75), 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false,
                          static_cast<unsigned>(random.bits()));
  static_cast<void>(method.evolve(population));
  anneal(search, static_cast<unsigned>(random.bits()), 0.05);
}

void evolve_by_differences(Search& search, int size, RandomStream& random) {
  const pagmo::population population = first_population(search, size, random);
  constexpr unsigned kRandOneBin = 7;
  const pagmo::de method(generations(search, size), 0.7, 0.9, kRandOneBin, 0.0, 0.0,
                         static_cast<unsigned>(random.bits()));
  static_cast<void>(method.evolve(population));
}

void check(const Eigen::VectorXd& start, const Eigen::VectorXd& half_widths,
           const PopulationSearchOptions& options) {
  if (start.size() == 0 || half_widths.size() != start.size() ||
      !(half_widths.array() > 0.0).all()) {
    throw std::invalid_argument(
        fmt::format("a search of {} parameters needs as many positive half widths, not {}",
                    start.size(), half_widths.size()));
  }
  if (options.population < kLeastPopulation || options.evaluations < 2 * options.population) {
    throw std::invalid_argument(fmt::format(
        "a population search needs at least {} members and evaluations for two generations; got "
        "{} members and {} evaluations",
        kLeastPopulation, options.population, options.evaluations));
  }
}

}  // namespace

PopulationSearch search_population(PopulationMethod method, const Objective& objective,
                                   const Eigen::VectorXd& start, const Eigen::VectorXd& half_widths,
                                   const PopulationSearchOptions& options) {
  check(start, half_widths, options);
  Search search(method, objective, start, half_widths, options);
  RandomStream random(options.seed);
  switch (method) {
    case PopulationMethod::annealing:
      search.evaluate(std::vector<double>(search.size(), 0.0));
      anneal(search, static_cast<unsigned>(random.bits()), 1.0);
      break;
    case PopulationMethod::genetic:
      breed(search, options.population, random);
      break;
    case PopulationMethod::particle_swarm:
      swarm(search, options.population, random);
      break;
    case PopulationMethod::differential_evolution:
      evolve_by_differences(search, options.population, random);
      break;
  }
  return search.finish();
}

#endif

}  // namespace armcal
