// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/scenario_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <variant>

#include "armcal/io/text_file.h"
#include "armcal/io/toml_value.h"
#include "armcal/workflow/scenario_errors.h"
#include "armcal/workflow/scenario_keys.h"

namespace armcal {
namespace {

// Names become names of files.
bool is_plain_name(const std::string& name) {
  constexpr std::size_t kLongest = 64;
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

Surroundings read_surroundings(TomlSection& section, Diagnostics& diagnostics) {
  Surroundings surroundings;
  read_keys(section,
            {scenario_key::amount("column_radius_mm", &Surroundings::column_radius_mm),
             scenario_key::amount("column_top_mm", &Surroundings::column_top_mm, AmountRange::any)},
            surroundings, diagnostics);
  surroundings.bench_mm = section.number("bench_mm");
  section.finish();
  return surroundings;
}

PlannedCheck read_check(TomlSection& section, Diagnostics& diagnostics) {
  PlannedCheck check;
  check.where = section.where();
  read_keys(section,
            {scenario_key::count("points", &PlannedCheck::points, 3),
             scenario_key::amount("u_mm", &PlannedCheck::u_mm)},
            check, diagnostics);
  section.finish();
  return check;
}

void check_names(const std::vector<PlannedMeasurement>& measurements, Diagnostics& diagnostics) {
  std::set<std::string> names = {"check"};
  for (const PlannedMeasurement& planned : measurements) {
    const std::string& name = name_of(planned.measurement);
    if (!is_plain_name(name)) {
      diagnostics.error(planned.where, fmt::format("the name \"{}\" is no name of a file", name),
                        "use letters, digits, - and _");
    } else if (name == "check") {
      diagnostics.error(planned.where, "the name \"check\" is taken by the check rows");
    } else if (!names.insert(name).second) {
      diagnostics.error(planned.where, fmt::format("two measurements are named \"{}\"", name),
                        "give one of them another name = \"..\"");
    }
  }
}

// The platform becomes a joint of the arm that the files describe.
void check_platforms(const std::vector<PlannedMeasurement>& measurements,
                     Diagnostics& diagnostics) {
  const PlannedMeasurement* platform = nullptr;
  for (const PlannedMeasurement& planned : measurements) {
    if (!std::holds_alternative<IndexedPlatform>(planned.measurement)) continue;
    if (platform != nullptr) {
      diagnostics.error(planned.where, "there is one indexed platform already",
                        "write a scenario for each");
    }
    platform = &planned;
  }
  if (platform == nullptr) return;
  for (const PlannedMeasurement& planned : measurements) {
    if (!std::holds_alternative<SymmetricPoint>(planned.measurement)) continue;
    diagnostics.error(planned.where, "a symmetric-point procedure is for an arm without platform",
                      "write a scenario for each");
  }
}

void check_truth(const SimulationScenario& scenario, TomlSection& root, Diagnostics& diagnostics) {
  if (scenario.truth_file.empty() || !scenario.errors.geometry.is_on()) return;
  diagnostics.error(root.where("truth"), "the geometry is given by truth and by [errors.geometry]",
                    "keep one of them");
}

}  // namespace

std::optional<SimulationScenario> read_scenario_file(const TextFile& file,
                                                     Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  TomlSection root(*document, diagnostics);
  check_schema(root, "scenario", diagnostics);
  SimulationScenario scenario;
  scenario.file = file.path;
  scenario.name = root.text("name").value_or("");
  static_cast<void>(root.text("note"));
  if (const auto arm = root.required_text("arm")) {
    scenario.arm_file = path_beside(file.path, *arm);
  }
  if (const auto truth = root.text("truth")) {
    scenario.truth_file = path_beside(file.path, *truth);
  }
  const int seed = root.integer("seed").value_or(1);
  if (seed < 0) diagnostics.error(root.where("seed"), "seed must not be negative");
  scenario.seed = static_cast<std::uint64_t>(std::max(seed, 0));
  read_keys(root,
            {scenario_key::amount("seconds_per_reading", &SimulationScenario::seconds_per_reading)},
            scenario, diagnostics);
  if (auto section = root.section("surroundings")) {
    scenario.surroundings = read_surroundings(*section, diagnostics);
  }
  if (auto section = root.section("errors")) {
    scenario.errors = read_error_sources(*section, diagnostics);
  }
  for (TomlSection& section : root.sections("measure")) {
    auto measurement = read_measurement(section, diagnostics);
    if (measurement) scenario.measurements.push_back({std::move(*measurement), section.where()});
  }
  if (!root.has("measure")) {
    diagnostics.error({file.path, 0, 0}, "measures nothing",
                      "write one [[measure]] for each instrument or artefact");
  }
  if (auto section = root.section("check")) scenario.check = read_check(*section, diagnostics);
  if (auto section = root.section("estimate")) {
    scenario.estimate = read_session_estimate(*section, diagnostics);
  }
  root.finish();
  check_names(scenario.measurements, diagnostics);
  check_platforms(scenario.measurements, diagnostics);
  check_truth(scenario, root, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return scenario;
}

}  // namespace armcal
