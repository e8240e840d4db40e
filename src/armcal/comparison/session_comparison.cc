// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/session_comparison.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "armcal/comparison/methods/registry.h"
#include "armcal/comparison/name_choice.h"
#include "armcal/comparison/task_queue.h"
#include "armcal/core/diagnostics.h"

namespace armcal {
namespace {

// Of all groups together.
ResidualStatistics pooled(const std::vector<ResidualStatistics>& parts) {
  ResidualStatistics all;
  double squares = 0.0;
  for (const ResidualStatistics& part : parts) {
    const auto count = static_cast<double>(part.count);
    all.count += part.count;
    squares += count * part.rms_mm * part.rms_mm;
    all.mean_mm += count * part.mean_mm;
    all.max_mm = std::max(all.max_mm, part.max_mm);
  }
  if (all.count == 0) return all;
  all.rms_mm = std::sqrt(squares / static_cast<double>(all.count));
  all.mean_mm /= static_cast<double>(all.count);
  return all;
}

/// @throws NumericalError where the rows are too few to place what they bring along
RowFigures figures_of(const ArmModel& arm, std::span<const ObservationGroup> groups) {
  CalibrationOptions only_places;
  only_places.hold = {"*"};
  const Calibration placed = calibrate(arm, groups, only_places);
  // Half turns bring nothing along: their residuals are those of the start.
  const bool no_places = placed.status == CalibrationStatus::nothing_determined;
  if (!placed.ok() && !no_places) {
    throw NumericalError("the rows cannot be placed: " + (placed.detail.empty()
                                                              ? std::string(explain(placed.status))
                                                              : placed.detail));
  }
  std::vector<ResidualStatistics> parts;
  for (const GroupResult& group : placed.groups)
    parts.push_back(no_places ? group.nominal : group.fit);
  RowFigures figures{pooled(parts), std::nullopt};
  if (!no_places && placed.degrees_of_freedom > 0) figures.over_stated = placed.sigma0;
  return figures;
}

std::vector<ObservationGroup> with_sets_exchanged(std::span<const ObservationGroup> groups) {
  std::vector<ObservationGroup> exchanged(groups.begin(), groups.end());
  for (ObservationGroup& group : exchanged) group.is_check.flip();
  return exchanged;
}

SessionComparisonRow row_of(const SessionMethod& method, const SessionReadings& readings,
                            std::span<const ObservationGroup> held_out) {
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
    row.fitted = figures_of(found.arm, readings.groups);
    row.held_out = figures_of(found.arm, held_out);
  } catch (const NumericalError& reason) {
    row.problem = reason.what();
  }
  return row;
}

}  // namespace

std::vector<SessionComparisonRow> compare_on_session(const ArmModel& nominal,
                                                     std::span<const ObservationGroup> groups,
                                                     const CalibrationOptions& calibration,
                                                     const SessionComparisonOptions& options) {
  const bool any_held_out = std::any_of(groups.begin(), groups.end(), [](const auto& group) {
    return std::find(group.is_check.begin(), group.is_check.end(), true) != group.is_check.end();
  });
  if (!any_held_out) throw std::invalid_argument("no row is held out to judge by");
  const auto methods = chosen_by_name(session_methods(), options.methods);
  SessionReadings readings{nominal, groups, calibration, options.seed};
  readings.calibration.monitor = {{}, options.monitor.stop};  // threads report through do_tasks
  const std::vector<ObservationGroup> held_out = with_sets_exchanged(groups);
  std::vector<double> efforts;
  for (const SessionMethod& method : methods) efforts.push_back(method.effort);
  std::vector<SessionComparisonRow> rows(methods.size());
  do_tasks(efforts, options.threads, options.monitor, "comparing methods",
           [&](std::size_t task) { rows[task] = row_of(methods[task], readings, held_out); });
  return rows;
}

}  // namespace armcal
