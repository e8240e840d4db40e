// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "estimate.h"

#include <algorithm>
#include <numeric>

#include "armcal/report/calibration_report.h"
#include "armcal/symmetric_point/adjustment.h"

namespace armcal::validation {
namespace {

std::vector<SymmetricReading> readings_of(const ObservationGroup& group) {
  std::vector<SymmetricReading> readings;
  for (Eigen::Index i = 0; i < group.count(); ++i) {
    SymmetricReading reading;
    reading.name = "half turn " + std::to_string(i + 1);
    reading.kind = SymmetricKind::reversal;
    reading.joint = group.joint[static_cast<std::size_t>(i)];
    reading.posture_rad = group.encoder_rad.col(i);
    reading.posture_end_rad = group.encoder_end_rad.col(i);
    reading.value = group.value_mm(i);
    reading.u = group.u_mm(i);
    reading.reduced = true;
    readings.push_back(std::move(reading));
  }
  return readings;
}

Estimate by_adjustment(const ArmModel& nominal, const ObservationGroup& half_turns) {
  AdjustmentOptions options;
  options.unknowns.resize(static_cast<std::size_t>(ParameterTable(nominal).size()));
  std::iota(options.unknowns.begin(), options.unknowns.end(), 0);
  const Adjustment adjustment = adjust(nominal, readings_of(half_turns), options);
  Estimate result;
  result.ok = adjustment.ok();
  result.problem = explain(adjustment.status);
  if (!result.ok) return result;
  // In the order of the table, as identification has them.
  std::vector<Eigen::Index> order(adjustment.unknowns.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&](Eigen::Index one, Eigen::Index other) {
    return adjustment.unknowns[static_cast<std::size_t>(one)] <
           adjustment.unknowns[static_cast<std::size_t>(other)];
  });
  for (const Eigen::Index place : order) {
    result.free.push_back(adjustment.unknowns[static_cast<std::size_t>(place)]);
  }
  result.arm = adjustment.arm;
  result.covariance = adjustment.covariance(order, order);
  result.chi_squared = adjustment.chi_squared;
  result.degrees_of_freedom = adjustment.degrees_of_freedom;
  return result;
}

}  // namespace

Estimate estimate(const Scenario& scenario, std::span<const ObservationGroup> groups) {
  if (scenario.by_adjustment) return by_adjustment(scenario.nominal, groups.front());
  const Calibration calibration = calibrate(scenario.nominal, groups, scenario.options);
  Estimate result;
  result.ok = calibration.ok();
  result.problem = explain(calibration.status);
  if (!result.ok) return result;
  result.arm = calibration.arm;
  result.free = calibration.free;
  result.covariance = calibration.covariance;
  result.chi_squared = calibration.chi_squared;
  result.degrees_of_freedom = calibration.degrees_of_freedom;
  result.says_scatter =
      text_result(calibration).find("the readings scatter more than stated") != std::string::npos;
  return result;
}

}  // namespace armcal::validation
