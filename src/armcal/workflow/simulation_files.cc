// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/simulation_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "armcal/io/arm_file.h"
#include "armcal/io/observation_writer.h"
#include "armcal/io/session_writer.h"
#include "armcal/io/symmetric_point_writer.h"

namespace armcal {
namespace {

constexpr const char* kNominal = "nominal.arm.toml";
constexpr const char* kTruth = "truth.arm.toml";

// "arms/romer.scenario.toml" is romer.
std::string stem_of(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  const std::string stem = name.substr(0, name.find('.'));
  return stem.empty() ? "simulated" : stem;
}

std::string origin(const Simulation& simulation, const SimulationScenario& scenario) {
  return fmt::format("Simulated from {} with seed {}.",
                     std::filesystem::path(scenario.file).filename().string(), simulation.seed);
}

class Writer {
 public:
  Writer(const Simulation& simulation, const SimulationScenario& scenario)
      : simulation_(simulation), scenario_(scenario), origin_(origin(simulation, scenario)) {}

  SimulationFiles write() {
    add_arm(kNominal, simulation_.nominal);
    ArmModel truth = simulation_.truth;
    truth.note = fmt::format("The true geometry. {}", origin_);
    add_arm(kTruth, truth);
    for (const SimulatedProcedure& each : simulation_.procedures) add_procedure(each);
    add_session();
    check_paths();
    return std::move(result_);
  }

 private:
  void add(const std::string& path, std::string text) {
    result_.files.push_back({path, std::move(text)});
  }
  void add_arm(const std::string& path, const ArmModel& arm) { add(path, arm_text(arm)); }

  void add_group(const ObservationGroup& group, Session& session) {
    GroupTexts texts = group_texts(group);
    const SessionGroup& entry = texts.entry;
    if (!entry.artefact_file.empty()) add(entry.artefact_file, std::move(texts.artefact_csv));
    if (!entry.file.empty()) add(entry.file, std::move(texts.readings_csv));
    session.groups.push_back(entry);
  }

  void add_session() {
    Session session;
    session.name = scenario_.name;
    session.file = stem_of(scenario_.file) + ".session.toml";
    session.arm_file = kNominal;
    session.estimate = scenario_.estimate;
    for (const ObservationGroup& group : simulation_.groups) add_group(group, session);
    if (simulation_.check) add_group(*simulation_.check, session);
    if (simulation_.groups.empty()) return;
    result_.session = session.file;
    add(session.file, session_text(session, origin_));
  }

  void add_procedure(const SimulatedProcedure& simulated) {
    SymmetricPointProcedure procedure = simulated.procedure;
    procedure.file = simulated.name + "/procedure.symmetric.toml";
    procedure.arm_file = kNominal;
    for (SymmetricReading& reading : procedure.readings) reading.raw->file.clear();
    name_point_files(procedure);
    for (const SymmetricReading& reading : procedure.readings) {
      add(reading.raw->file, raw_points_csv(reading));
    }
    result_.procedures.push_back(procedure.file);
    add(procedure.file, symmetric_point_text(procedure, simulated.name, origin_));
  }

  void check_paths() const {
    Diagnostics diagnostics;
    std::set<std::string> paths;
    for (const FileText& file : result_.files) {
      if (paths.insert(file.path).second) continue;
      diagnostics.error({scenario_.file, 0, 0},
                        fmt::format("two measurements would write {}", file.path),
                        "give one of them another name = \"..\"");
    }
    if (diagnostics.has_errors()) throw InputError(diagnostics);
  }

  const Simulation& simulation_;
  const SimulationScenario& scenario_;
  std::string origin_;
  SimulationFiles result_;
};

}  // namespace

SimulationFiles simulation_files(const Simulation& simulation, const SimulationScenario& scenario) {
  return Writer(simulation, scenario).write();
}

}  // namespace armcal
