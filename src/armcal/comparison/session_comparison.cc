// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/session_comparison.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/name_choice.h"
#include "armcal/comparison/task_queue.h"
#include "armcal/core/diagnostics.h"

namespace armcal {
namespace {

SessionComparisonRow row_of(const SessionMethod& method, const SessionReadings& readings) {
  SessionComparisonRow row;
  row.name = method.name;
  row.title = method.title;
  try {
    const auto start = std::chrono::steady_clock::now();
    const FoundArm found = method.compute(readings);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.parameters = static_cast<int>(found.free.size());
    row.condition_number = found.condition_number;
    row.remark = found.remark;
    row.fitted = row_figures(found.arm, readings.groups, false);
    row.held_out = row_figures(found.arm, readings.groups, true);
  } catch (const NumericalError& reason) {
    row.problem = reason.what();
  }
  return row;
}

}  // namespace

SessionComparison compare_on_session(const ArmModel& nominal,
                                     std::span<const ObservationGroup> groups,
                                     const CalibrationOptions& calibration,
                                     const SessionComparisonOptions& options) {
  SessionComparison comparison;
  comparison.arm_name = nominal.name;
  for (const ObservationGroup& group : groups) {
    const auto held_out = std::count(group.is_check.begin(), group.is_check.end(), true);
    comparison.held_out += held_out;
    comparison.fitted += group.count() - held_out;
  }
  if (comparison.held_out == 0) throw std::invalid_argument("no row is held out to judge by");
  const auto methods = chosen_by_name(session_methods(), options.methods);
  SessionReadings readings{nominal, groups, calibration, options.seed};
  readings.calibration.monitor = {{}, options.monitor.stop};  // threads report through do_tasks
  std::vector<double> efforts;
  for (const SessionMethod& method : methods) efforts.push_back(method.effort);
  comparison.rows.resize(methods.size());
  do_tasks(efforts, options.threads, options.monitor, "comparing methods",
           [&](std::size_t task) { comparison.rows[task] = row_of(methods[task], readings); });
  return comparison;
}

}  // namespace armcal
