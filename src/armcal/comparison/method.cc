// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/method.h"

#include "armcal/core/diagnostics.h"

namespace armcal {

FoundArm found_arm(const Calibration& calibration) {
  if (!calibration.ok()) {
    throw NumericalError(calibration.detail.empty() ? std::string(explain(calibration.status))
                                                    : calibration.detail);
  }
  return {calibration.arm,
          calibration.free,
          calibration.covariance.diagonal().cwiseSqrt(),
          calibration.condition_number,
          {}};
}

}  // namespace armcal
