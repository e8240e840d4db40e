// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/symmetric_point_job.h"

#include <fmt/format.h>

#include <map>

#include "armcal/io/symmetric_point_file.h"

namespace armcal {
namespace {

void read_raw_points(InputFiles& files, SymmetricPointProcedure& procedure, int joint_count,
                     const TableOptions& options) {
  std::map<std::string, std::optional<CsvTable>> tables;  // several readings may share one
  for (SymmetricReading& reading : procedure.readings) {
    if (!reading.raw) continue;
    const std::string& path = reading.raw->file;
    if (!tables.contains(path)) tables.emplace(path, files.table(path, options));
    if (!tables.at(path)) continue;
    const auto table = rows_of_reading(*tables.at(path), reading.name, files.diagnostics());
    if (!table) continue;
    auto raw = symmetric_points(*table, reading, joint_count, options, files.diagnostics());
    if (raw) reading.raw = std::move(*raw);
  }
}

}  // namespace

SymmetricPointAnalysis run_symmetric_point(InputFiles& files, const std::string& path,
                                           const std::optional<std::string>& compare_path,
                                           const TableOptions& options) {
  const auto text = files.text(path, kLargestConfiguration_bytes);
  files.require_good();
  auto procedure = read_symmetric_point_file(*text, files.diagnostics());
  files.require_good();
  const auto arm = files.arm(procedure->arm_file);
  const auto compared = compare_path ? files.arm(*compare_path) : std::nullopt;
  files.require_good();
  check_against_arm(*procedure, *arm, files.diagnostics());
  if (compared && compared->joint_count() != arm->joint_count()) {
    files.diagnostics().error({*compare_path, 0, 0},
                              fmt::format("has {} joints, the arm of the readings {}",
                                          compared->joint_count(), arm->joint_count()));
  }
  files.require_good();
  read_raw_points(files, *procedure, arm->joint_count(), options);
  files.require_good();
  auto analysis = analyse_symmetric_points(*procedure, *arm, compared, files.diagnostics());
  files.require_good();
  const Adjustment& adjustment = analysis->adjustment;
  if (!adjustment.ok()) {
    throw NumericalError(
        fmt::format("{}: {}{}", path, explain(adjustment.status),
                    adjustment.detail.empty() ? "" : " (" + adjustment.detail + ")"));
  }
  return std::move(*analysis);
}

}  // namespace armcal
