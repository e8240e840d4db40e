// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/comparison.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "armcal/comparison/core_time.h"
#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/name_choice.h"
#include "armcal/comparison/task_queue.h"
#include "armcal/core/diagnostics.h"
#include "armcal/numerics/median.h"

namespace armcal {
namespace {

struct Outcome {
  int readings = 0;
  std::optional<Score> score;
  double seconds = 0.0;
  std::optional<double> condition_number;
  std::string remark;
  std::string problem;
};

// Of a table; what could be done about it is for those who ask for just this.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

Outcome outcome_of(const Method& method, const Bench& bench, const Judge& judge) {
  Outcome outcome;
  try {
    const TakenReadings taken = method.take(bench);
    outcome.readings = taken.count;
    const double start = core_seconds();
    const FoundArm found = taken.compute();
    outcome.seconds = core_seconds() - start;
    outcome.condition_number = found.condition_number;
    outcome.remark = found.remark;
    outcome.score = judge.score(found);
  } catch (const Impossible& reason) {
    outcome.problem = first_line(reason.what());
  } catch (const NumericalError& reason) {
    outcome.problem = first_line(reason.what());
  }
  return outcome;
}

ComparisonRow row_of(const Method& method, const std::vector<const Outcome*>& outcomes) {
  ComparisonRow row{method.name, method.title, method.reference, method.needs};
  std::vector<const Outcome*> good;
  for (const Outcome* outcome : outcomes) {
    row.readings = std::max(row.readings, outcome->readings);
    if (row.problem.empty()) row.problem = outcome->problem;
    if (outcome->score) good.push_back(outcome);
  }
  row.arms = static_cast<int>(good.size());
  if (good.empty()) return row;
  const auto middle = [&](const auto& figure) {
    std::vector<double> values;
    for (const Outcome* outcome : good) values.push_back(figure(*outcome));
    return median(values);
  };
  const auto middle_score = [&](double Score::*figure) {
    return middle([&](const Outcome& outcome) { return *outcome.score.*figure; });
  };
  for (double Score::*figure : {&Score::point_rms_mm, &Score::point_mean_mm, &Score::point_max_mm,
                                &Score::length_rms_mm, &Score::noise_ratio}) {
    row.score.*figure = middle_score(figure);
  }
  for (const Outcome* outcome : good) {
    row.score.intervals += outcome->score->intervals;
    row.score.inside += outcome->score->inside;
  }
  row.seconds = middle([](const Outcome& outcome) { return outcome.seconds; });
  row.condition_number = good.front()->condition_number;
  row.remark = good.front()->remark;
  return row;
}

}  // namespace

Comparison compare_methods(const Scenario& scenario, const ComparisonOptions& options) {
  const std::vector<Method> methods = chosen_by_name(all_methods(), options.methods);
  if (options.repeats < 1) throw std::invalid_argument("methods are compared on one arm at least");
  const auto repeats = static_cast<std::size_t>(options.repeats);
  std::vector<Bench> benches;
  std::vector<Judge> judges;
  std::vector<double> floors;
  for (std::size_t r = 0; r < repeats; ++r) {
    benches.push_back(bench_of(scenario, options.seed + r));
    // Threads report through their own door.
    benches.back().monitor.stop = options.monitor.stop;
    judges.emplace_back(benches.back().arm, scenario.u_reference_mm, benches.back().seed);
    floors.push_back(judges.back().noise_floor_mm());
    options.monitor.report("drawing arms", static_cast<double>(r + 1) / options.repeats);
  }
  std::vector<double> efforts;
  for (const Method& method : methods) efforts.insert(efforts.end(), repeats, method.effort);
  std::vector<Outcome> outcomes(efforts.size());
  do_tasks(efforts, options.threads, options.monitor, "comparing methods", [&](std::size_t task) {
    const std::size_t r = task % repeats;
    outcomes[task] = outcome_of(methods[task / repeats], benches[r], judges[r]);
  });

  Comparison comparison{scenario, options.seed, options.repeats, median(floors), {}};
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<const Outcome*> of_method;
    for (std::size_t r = 0; r < repeats; ++r) of_method.push_back(&outcomes[m * repeats + r]);
    comparison.rows.push_back(row_of(methods[m], of_method));
  }
  return comparison;
}

}  // namespace armcal
