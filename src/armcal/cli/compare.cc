// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/cli/commands.h"
#include "armcal/comparison/comparison.h"
#include "armcal/report/comparison_report.h"

namespace armcal::cli {
namespace {

struct Flags {
  std::optional<std::string> session;
  std::optional<std::string> scenario;
  std::vector<std::string> methods;
  std::optional<double> seed, repeats, threads;
  std::optional<std::string> markdown;
};

/// @throws std::invalid_argument for "--repeats 2.5"
std::uint64_t whole_number(const std::string& flag, const std::optional<double>& typed,
                           std::uint64_t otherwise) {
  if (!typed) return otherwise;
  constexpr double kLargest = 1e15;
  if (*typed != std::floor(*typed) || *typed > kLargest) {
    throw std::invalid_argument(fmt::format("{} {}: must be a whole number", flag, *typed));
  }
  return static_cast<std::uint64_t>(*typed);
}

int run_scenario(const Flags& flags, const Context& context) {
  const std::string name = flags.scenario.value_or(scenario_names().front());
  ComparisonOptions options;
  if (!flags.methods.empty()) options.methods = flags.methods;
  options.seed = whole_number("--seed", flags.seed, options.seed);
  options.repeats = static_cast<int>(whole_number("--repeats", flags.repeats, 1));
  options.threads = static_cast<int>(whole_number("--threads", flags.threads, 2));
  options.monitor = context.monitor;
  const Comparison comparison = compare_methods(*scenario_named(name), options);
  if (flags.markdown) context.save(*flags.markdown, markdown_result(comparison), {});
  context.emit({}, {}, json_result(comparison), text_result(comparison));
  return kDone;
}

}  // namespace

Command compare_command() {
  const auto flags = std::make_shared<Flags>();
  Command command;
  command.name = "compare";
  command.brief = "every method on the same arm, one table";
  command.description = "Draws an arm with errors of known size.";
  command.arguments = {
      {"--scenario", "the arm and its errors; romer if not given", &flags->scenario, "NAME", false,
       scenario_names()},
      {"--methods", "only methods whose names match this pattern; may be repeated", &flags->methods,
       "GLOB"},
      {"--seed",
       "of the random numbers; 1 if not given",
       &flags->seed,
       "N",
       false,
       {},
       NumberRange::not_negative},
      {"--repeats",
       "so many arms, and medians over them",
       &flags->repeats,
       "N",
       false,
       {},
       NumberRange::positive},
      {"--threads",
       "never changes a digit (but times); 2 if not given",
       &flags->threads,
       "N",
       false,
       {},
       NumberRange::positive},
      {"--markdown", "write the table here, for a page", &flags->markdown, "FILE"}};
  command.examples = {"armcal compare --methods cmm"};
  command.run = [flags](const Context& context) { return run_scenario(*flags, context); };
  return command;
}

}  // namespace armcal::cli
