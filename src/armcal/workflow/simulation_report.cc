// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/simulation_report.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "armcal/io/sha256.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

std::string in_folder(const std::string& folder, const std::string& path) {
  return (std::filesystem::path(folder) / path).lexically_normal().string();
}

std::size_t points_of(const SymmetricPointProcedure& procedure) {
  std::size_t count = 0;
  for (const SymmetricReading& reading : procedure.readings) {
    count += reading.raw ? reading.raw->points_mm.size() : 0;
  }
  return count;
}

std::string readings_text(const Simulation& simulation) {
  TextTable table({{"readings", Align::left}, {"kind", Align::left}, {"count"}});
  const auto add = [&](const ObservationGroup& group) {
    table.add_row({group.name, std::string(to_string(group.kind)), std::to_string(group.count())});
  };
  for (const ObservationGroup& group : simulation.groups) add(group);
  if (simulation.check) add(*simulation.check);
  for (const SimulatedProcedure& each : simulation.procedures) {
    table.add_row({each.name, "symmetric_point",
                   fmt::format("{} of {} points", each.procedure.readings.size(),
                               points_of(each.procedure))});
  }
  return table.text();
}

}  // namespace

std::string text_result(const Simulation& simulation, const SimulationFiles& files,
                        const SimulationScenario& scenario, const std::string& folder) {
  constexpr int kDecimals = 4;
  std::string text = fmt::format(
      "{}\n  seed {}\n  the drawing misses true tips by {} mm rms\n  floor: the noise of the "
      "encoders alone moves a tip by {} mm rms\n\n{}\nWritten to {}\n",
      scenario.name.empty() ? scenario.file : scenario.name, simulation.seed,
      fixed(simulation.drawing_error_mm, kDecimals), fixed(simulation.floor_mm, kDecimals),
      readings_text(simulation), folder);
  for (const FileText& file : files.files) text += fmt::format("  {}\n", file.path);
  text += "\nGo on with\n";
  if (!files.session.empty()) {
    text += fmt::format("  armcal calibrate {}\n", in_folder(folder, files.session));
  }
  for (const std::string& procedure : files.procedures) {
    text += fmt::format("  armcal symmetric-point {}\n", in_folder(folder, procedure));
  }
  return text;
}

Json json_result(const Simulation& simulation, const SimulationFiles& files,
                 const SimulationScenario& scenario, const std::string& folder) {
  Json json;
  json["scenario"] = scenario.name;
  json["floor_mm"] = simulation.floor_mm;
  json["drawing_error_mm"] = simulation.drawing_error_mm;
  json["readings"] = Json::array();
  const auto add = [&](const ObservationGroup& group, const char* set) {
    json["readings"].push_back({{"name", group.name},
                                {"kind", to_string(group.kind)},
                                {"count", group.count()},
                                {"set", set}});
  };
  for (const ObservationGroup& group : simulation.groups) add(group, "fit");
  if (simulation.check) add(*simulation.check, "check");
  json["procedures"] = Json::array();
  for (const SimulatedProcedure& each : simulation.procedures) {
    json["procedures"].push_back({{"name", each.name},
                                  {"readings", each.procedure.readings.size()},
                                  {"points", points_of(each.procedure)}});
  }
  json["folder"] = folder;
  json["files"] = Json::array();
  for (const FileText& file : files.files) {
    json["files"].push_back({{"path", in_folder(folder, file.path)},
                             {"bytes", file.text.size()},
                             {"sha256", sha256_hex(file.text)}});
  }
  return json;
}

}  // namespace armcal
