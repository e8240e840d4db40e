// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/cli/commands.h"
#include "armcal/report/text_table.h"
#include "armcal/workflow/simulation_job.h"
#include "armcal/workflow/simulation_report.h"

namespace armcal::cli {
namespace {

struct SimulateFlags {
  std::optional<std::string> file;
  std::optional<std::string> scenario;
  std::optional<std::string> folder;
  std::optional<double> seed;
  bool list = false;
};

int list_scenarios(const Context& context) {
  TextTable table({{"scenario", Align::left}, {"", Align::left}});
  Json json;
  json["scenarios"] = Json::array();
  for (const BuiltInScenario& each : built_in_scenarios()) {
    table.add_row({each.name, each.brief});
    json["scenarios"].push_back({{"name", each.name}, {"brief", each.brief}, {"path", each.path}});
  }
  context.emit({}, {}, json, table.text());
  return kDone;
}

int run_simulate(const SimulateFlags& flags, const Context& context) {
  if (flags.list) return list_scenarios(context);
  if (flags.file.has_value() == flags.scenario.has_value()) {
    throw std::invalid_argument(
        "give either a scenario file or --scenario NAME\n  help: armcal simulate --list shows the "
        "built-in ones");
  }
  if (!flags.folder) {
    throw std::invalid_argument("give the folder to write to: -o FOLDER");
  }
  InputFiles files(context.monitor, flags.scenario ? FileSource::embedded : FileSource::disk);
  const LoadedScenario loaded =
      load_scenario(files, flags.scenario ? built_in_scenario(*flags.scenario).path : *flags.file);
  const Simulation simulation =
      simulate(loaded, seed_or(flags.seed, loaded.scenario.seed), context.monitor);
  const SimulationFiles written = simulation_files(simulation, loaded.scenario);
  for (const FileText& file : written.files) {
    require_no_input((std::filesystem::path(*flags.folder) / file.path).string(), files.records());
  }
  write_simulation(written, *flags.folder, context.overwrite);
  context.emit(files.records(), files.diagnostics(),
               json_result(simulation, written, loaded.scenario, *flags.folder),
               text_result(simulation, written, loaded.scenario, *flags.folder), simulation.seed);
  return kDone;
}

}  // namespace

Command simulate_command() {
  const auto flags = std::make_shared<SimulateFlags>();
  Command command;
  command.name = "simulate";
  command.brief = "a virtual arm with known errors, and readings of it with any instrument";
  command.description =
      "Reads a scenario (*.scenario.toml): an arm, what is wrong with it, and what it is measured "
      "with. Draws the true\n"
      "arm, takes the readings, and writes them as a laboratory would: drawing, truth, session and "
      "tables.";
  command.arguments = {
      {"SCENARIO", "scenario file (*.scenario.toml)", &flags->file},
      {"--scenario", "a built-in scenario instead of a file", &flags->scenario, "NAME"},
      {"-o,--output", "write the files into this folder", &flags->folder, "FOLDER"},
      {"--seed", "draw another arm and other readings; default: that of the scenario", &flags->seed,
       "N", NumberRange::seed},
      {"--list", "name the built-in scenarios", &flags->list}};
  command.examples = {"armcal simulate --list", "armcal simulate --scenario romer -o my-romer",
                      "armcal simulate examples/scenarios/digitizer.scenario.toml -o my-digitizer "
                      "--seed 7"};
  command.run = [flags](const Context& context) { return run_simulate(*flags, context); };
  return command;
}

}  // namespace armcal::cli
