// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/simulation_job.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "armcal/core/spelling.h"
#include "armcal/io/symmetric_point_file.h"
#include "armcal/io/text_file.h"
#include "armcal/workflow/embedded_files.h"

namespace armcal {
namespace {

std::optional<SymmetricPointProcedure> plan_of(InputFiles& files, const SymmetricPoint& options,
                                               const std::string& scenario) {
  if (options.procedure.empty()) return wang2016_procedure();
  const auto text =
      files.text(path_beside(scenario, options.procedure), kLargestConfiguration_bytes);
  return text ? read_symmetric_point_file(*text, files.diagnostics()) : std::nullopt;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw FileError(
        fmt::format("{}: cannot make this folder: {}", folder.string(), error.message()));
}

}  // namespace

LoadedScenario load_scenario(InputFiles& files, const std::string& path) {
  const auto text = files.text(path, kLargestConfiguration_bytes);
  files.require_good();
  auto scenario = read_scenario_file(*text, files.diagnostics());
  files.require_good();
  const auto nominal = files.arm(scenario->arm_file);
  auto truth = scenario->truth_file.empty() ? std::nullopt : files.arm(scenario->truth_file);
  std::map<std::string, SymmetricPointProcedure> plans;
  for (const PlannedMeasurement& planned : scenario->measurements) {
    const auto* symmetric = std::get_if<SymmetricPoint>(&planned.measurement);
    if (symmetric == nullptr) continue;
    if (auto plan = plan_of(files, *symmetric, path)) plans[symmetric->name] = std::move(*plan);
  }
  files.require_good();
  if (truth && truth->joint_count() != nominal->joint_count()) {
    files.diagnostics().error(
        {scenario->truth_file, 0, 0},
        fmt::format("has {} joints, the arm {}", truth->joint_count(), nominal->joint_count()));
  }
  files.require_good();
  return {std::move(*scenario), *nominal, std::move(truth), std::move(plans)};
}

std::vector<BuiltInScenario> built_in_scenarios() {
  constexpr std::string_view kFolder = "examples/scenarios/";
  constexpr std::string_view kEnding = ".scenario.toml";
  std::vector<BuiltInScenario> all;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.path.starts_with(kFolder) || !file.path.ends_with(kEnding)) continue;
    const std::string path(file.path);
    Diagnostics diagnostics;
    const auto scenario =
        read_scenario_file({path, std::string(file.text), "UTF-8", ""}, diagnostics);
    all.push_back({path.substr(kFolder.size(), path.size() - kFolder.size() - kEnding.size()), path,
                   scenario ? scenario->name : ""});
  }
  return all;
}

BuiltInScenario built_in_scenario(std::string_view name) {
  std::vector<std::string> names;
  for (BuiltInScenario& each : built_in_scenarios()) {
    if (each.name == name) return std::move(each);
    names.push_back(each.name);
  }
  throw std::invalid_argument(fmt::format("no built-in scenario is called \"{}\"\n  help: {}", name,
                                          did_you_mean(name, names)));
}

void write_simulation(const SimulationFiles& files, const std::string& folder,
                      Overwrite overwrite) {
  const std::filesystem::path root(folder);
  Diagnostics diagnostics;
  std::error_code ignored;
  if (std::filesystem::exists(root, ignored) && !std::filesystem::is_directory(root, ignored)) {
    diagnostics.error({folder, 0, 0}, "is a file, not a folder");
    throw InputError(diagnostics);
  }
  for (const FileText& file : files.files) {
    try {
      check_may_overwrite((root / file.path).string(), overwrite);
    } catch (const InputError& error) {
      diagnostics.append(error.diagnostics());
    }
  }
  if (diagnostics.has_errors()) throw InputError(diagnostics);
  for (const FileText& file : files.files) {
    const std::filesystem::path path = root / file.path;
    make_folder(path.parent_path());
    write_file(path.string(), file.text, overwrite);
  }
}

}  // namespace armcal
