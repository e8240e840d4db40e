// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/verification_plan_job.h"

namespace armcal {

VerificationPlan run_verification_plan(InputFiles& files, const std::string& arm_path,
                                       const VerificationPlanWishes& wishes) {
  const auto arm = files.arm(arm_path);
  files.require_good();
  return plan_verification(*arm, wishes, files.monitor());
}

}  // namespace armcal
