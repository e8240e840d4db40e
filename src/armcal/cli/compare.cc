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
#include "armcal/report/session_comparison_report.h"
#include "armcal/workflow/comparison_job.h"

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

int threads_of(const Flags& flags) {
  return static_cast<int>(whole_number("--threads", flags.threads, 2));
}

void emit(const Flags& flags, const Context& context, InputFiles& files,
          const auto& comparison) {
  if (flags.markdown) context.save(*flags.markdown, markdown_result(comparison), files.records());
  context.emit(files.records(), files.diagnostics(), json_result(comparison),
               text_result(comparison));
}

int run_scenario(const Flags& flags, const Context& context) {
  ComparisonOptions options;
  if (!flags.methods.empty()) options.methods = flags.methods;
  options.seed = whole_number("--seed", flags.seed, options.seed);
  options.repeats = static_cast<int>(whole_number("--repeats", flags.repeats, 1));
  options.threads = threads_of(flags);
  options.monitor = context.monitor;
  const std::string name = flags.scenario.value_or(scenario_names().front());
  InputFiles no_files;
  emit(flags, context, no_files, compare_methods(*scenario_named(name), options));
  return kDone;
}

int run_session(const Flags& flags, const Context& context) {
  if (flags.scenario || flags.repeats) {
    throw std::invalid_argument(fmt::format("{} is for drawn arms; a session has its own",
                                            flags.scenario ? "--scenario" : "--repeats"));
  }
  SessionComparisonOptions options;
  if (!flags.methods.empty()) options.methods = flags.methods;
  options.seed = whole_number("--seed", flags.seed, options.seed);
  options.threads = threads_of(flags);
  options.monitor = context.monitor;
  InputFiles files(context.monitor);
  emit(flags, context, files, run_session_comparison(files, *flags.session, options));
  return kDone;
}

int run_compare(const Flags& flags, const Context& context) {
  if (flags.markdown) check_may_write(*flags.markdown, context.overwrite);
  return flags.session ? run_session(flags, context) : run_scenario(flags, context);
}

}  // namespace

Command compare_command() {
  const auto flags = std::make_shared<Flags>();
  Command command;
  command.name = "compare";
  command.brief = "every method on the same arm, one table";
  command.description = "Draws an arm with errors of known size.";
  command.arguments = {
      {"SESSION", "session file (*.session.toml); without one, an arm is drawn", &flags->session},
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
  command.run = [flags](const Context& context) { return run_compare(*flags, context); };
  return command;
}

}  // namespace armcal::cli
