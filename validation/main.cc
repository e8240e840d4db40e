// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// Statistical validation: many simulated calibrations of each scenario, held against what their
// uncertainties promise. docs/validation.md. Ends with 1 where a figure is out of its bounds.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "armcal/core/parallel.h"
#include "armcal/report/text_table.h"
#include "judgement.h"

namespace {

using armcal::Align;
using namespace armcal::validation;

std::string bound(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : ""; }

// A table of what was found; true where all of it passes.
bool report(const Scenario& scenario, const std::vector<Finding>& findings, int trials,
            double seconds) {
  armcal::TextTable table({{scenario.name, Align::left},
                           {"found"},
                           {"from"},
                           {"to"},
                           {"verdict", Align::left},
                           {"", Align::left}});
  bool all = true;
  for (const Finding& each : findings) {
    table.add_row({each.what, fmt::format("{:.4g}", each.value), bound(each.lowest),
                   bound(each.highest), each.passes() ? "pass" : "FAIL", each.note});
    all = all && each.passes();
  }
  fmt::print("{}\n{}\n", scenario.description, table.text());
  std::fflush(stdout);
  fmt::print(stderr, "{}: {} trials in {:.1f} s\n", scenario.name, trials, seconds);
  return all;
}

struct Settings {
  int trials = 2000;
  int threads = 2;
  std::uint64_t seed = 1;
  double noise_factor = 1.0;
  std::string only;
  std::string examples = ARMCAL_EXAMPLES;
};

bool validate(const Scenario& scenario, const Settings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  const Plan plan = plan_of(scenario, settings.seed, settings.noise_factor);
  std::vector<Trial> trials(static_cast<std::size_t>(settings.trials));
  armcal::parallel_for(settings.trials, settings.threads, [&](int trial, int) {
    trials[static_cast<std::size_t>(trial)] = run_trial(plan, trial);
  });
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return report(scenario, judge(plan, trials), settings.trials, elapsed.count());
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("Holds simulated calibrations against what their uncertainties promise");
  app.add_option("--trials", settings.trials, "of each scenario")->check(CLI::Range(2, 1000000));
  app.add_option("--threads", settings.threads, "never changes a digit")->check(CLI::Range(1, 256));
  app.add_option("--seed", settings.seed);
  app.add_option("--noise-factor", settings.noise_factor,
                 "how much larger noise is than stated: the judge must see it")
      ->check(CLI::PositiveNumber);
  app.add_option("--scenario", settings.only, "only this one");
  app.add_option("--examples", settings.examples, "folder of the example arms");
  CLI11_PARSE(app, argc, argv);
  try {
    bool all = true;
    int count = 0;
    for (const Scenario& scenario : all_scenarios(settings.examples)) {
      if (!settings.only.empty() && scenario.name != settings.only) continue;
      all = validate(scenario, settings) && all;
      ++count;
    }
    if (count == 0) {
      fmt::print(stderr, "there is no scenario \"{}\"\n", settings.only);
      return 2;
    }
    fmt::print("{} scenarios of {} trials, seed {}: {}\n", count, settings.trials, settings.seed,
               all ? "all pass" : "NOT all pass");
    return all ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 4;
  }
}
