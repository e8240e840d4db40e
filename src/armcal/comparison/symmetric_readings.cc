// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/symmetric_readings.h"

#include "armcal/core/diagnostics.h"

namespace armcal {

int count_readings(const SymmetricPointProcedure& carried_out) {
  std::size_t count = 0;
  for (const SymmetricReading& reading : carried_out.readings) {
    if (reading.raw) count += reading.raw->points_mm.size();
  }
  return static_cast<int>(count);
}

SymmetricPointAnalysis analysed(const SymmetricPointProcedure& procedure, const ArmModel& nominal) {
  Diagnostics diagnostics;
  auto analysis = analyse_symmetric_points(procedure, nominal, std::nullopt, diagnostics);
  if (!analysis) throw NumericalError(diagnostics.to_text());
  return std::move(*analysis);
}

FoundArm found_arm(const Adjustment& adjustment) {
  if (!adjustment.ok()) {
    throw NumericalError(adjustment.detail.empty() ? std::string(explain(adjustment.status))
                                                   : adjustment.detail);
  }
  return {adjustment.arm,
          adjustment.unknowns,
          adjustment.covariance.diagonal().cwiseSqrt(),
          adjustment.condition_number,
          {}};
}

}  // namespace armcal
