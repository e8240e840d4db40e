// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/cli/commands.h"
#include "armcal/comparison/comparison.h"
#include "armcal/report/comparison_report.h"
#include "armcal/report/paper_sphere_report.h"
#include "armcal/report/session_comparison_report.h"
#include "armcal/workflow/comparison_job.h"

namespace armcal::cli {
namespace {

struct CompareFlags {
  std::optional<std::string> session;
  std::optional<std::string> scenario;
  std::vector<std::string> methods;
  std::optional<double> readings, seed, repeats, threads;
  bool paper_sphere = false;
  std::optional<std::string> markdown;
};

void emit(const CompareFlags& flags, const Context& context, InputFiles& files,
          const auto& comparison) {
  if (flags.markdown) context.save(*flags.markdown, markdown_result(comparison), files.records());
  context.emit(files.records(), files.diagnostics(), json_result(comparison),
               text_result(comparison), seed_or(flags.seed, 1));
}

int run_scenario(const CompareFlags& flags, const Context& context) {
  ComparisonOptions options;
  if (!flags.methods.empty()) options.methods = flags.methods;
  options.seed = seed_or(flags.seed, 1);
  options.repeats = count_or(flags.repeats, options.repeats);
  options.threads = threads_of(flags.threads);
  options.monitor = context.monitor;
  InputFiles files(context.monitor);
  Scenario scenario = scenario_to_compare(files, flags.scenario.value_or(scenario_names().front()));
  scenario.readings = count_or(flags.readings, scenario.readings);
  emit(flags, context, files, compare_methods(scenario, options));
  return kDone;
}

int run_session(const CompareFlags& flags, const Context& context) {
  if (flags.scenario || flags.repeats || flags.readings) {
    throw std::invalid_argument(
        "--scenario, --repeats and --readings are for drawn arms; a session has its own");
  }
  SessionComparisonOptions options;
  if (!flags.methods.empty()) options.methods = flags.methods;
  options.seed = seed_or(flags.seed, 1);
  options.threads = threads_of(flags.threads);
  options.monitor = context.monitor;
  InputFiles files(context.monitor);
  emit(flags, context, files, run_session_comparison(files, *flags.session, options));
  return kDone;
}

int run_paper_sphere(const CompareFlags& flags, const Context& context) {
  if (flags.session || flags.scenario || flags.readings || !flags.methods.empty()) {
    throw std::invalid_argument("--paper-sphere has its own arm and method");
  }
  PaperSphereOptions options;
  options.arms = count_or(flags.repeats, options.arms);
  options.seed = seed_or(flags.seed, 1);
  options.threads = threads_of(flags.threads);
  options.monitor = context.monitor;
  InputFiles no_files;
  emit(flags, context, no_files, study_paper_sphere(options));
  return kDone;
}

int run_compare(const CompareFlags& flags, const Context& context) {
  if (flags.markdown) check_may_write(*flags.markdown, context.overwrite);
  if (flags.paper_sphere) return run_paper_sphere(flags, context);
  return flags.session ? run_session(flags, context) : run_scenario(flags, context);
}

}  // namespace

Command compare_command() {
  const auto flags = std::make_shared<CompareFlags>();
  Command command;
  command.name = "compare";
  command.brief = "every method on the same arm, one table";
  command.description =
      "Draws an arm with errors of known size and calibrates it by every published method that "
      "armcal knows, each with\n"
      "about the same number of readings and references of the same quality; judges all of them on "
      "postures that none has\n"
      "seen. With a SESSION: the methods that need no readings of their own, on these readings, "
      "judged on rows held out.";
  command.arguments = {
      {"SESSION", "session file (*.session.toml); without one, an arm is drawn", &flags->session},
      {"--scenario",
       fmt::format("the arm and its errors: {}, or a scenario file (*.scenario.toml)",
                   fmt::join(scenario_names(), ", ")),
       &flags->scenario, "NAME"},
      {"--methods", "only methods whose names match this pattern; may be repeated", &flags->methods,
       "GLOB"},
      {"--seed", "of the random numbers; 1 if not given", &flags->seed, "N", NumberRange::seed},
      {"--readings", "budget of each method; 120 if not given", &flags->readings, "N",
       NumberRange::count},
      {"--repeats", "so many arms, and medians over them", &flags->repeats, "N",
       NumberRange::count},
      {"--threads", "at most so many; never changes a digit (but of times); all cores if not given",
       &flags->threads, "N", NumberRange::count},
      {"--paper-sphere",
       "instead: which effect that the 2016 paper neglects explains the error of its sphere",
       &flags->paper_sphere},
      {"--markdown", "write the table here, for a page", &flags->markdown, "FILE"}};
  command.examples = {
      "armcal compare --scenario romer --methods cmm --methods paper-*",
      "armcal compare --scenario examples/scenarios/digitizer.scenario.toml --methods cmm",
      "armcal compare examples/calibration/tracker.session.toml --methods least-squares*",
      "armcal compare --paper-sphere --repeats 5"};
  command.run = [flags](const Context& context) { return run_compare(*flags, context); };
  return command;
}

}  // namespace armcal::cli
