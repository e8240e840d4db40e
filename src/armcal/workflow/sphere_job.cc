// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/sphere_job.h"

#include <fmt/format.h>

#include "armcal/report/sphere_test_report.h"

namespace armcal {

SphereTest run_sphere_test(InputFiles& files, const std::string& readings_path,
                           const std::optional<std::string>& arm_path,
                           const SphereTestOptions& options, const TableOptions& table_options) {
  SphereTest test;
  if (arm_path) {
    const auto arm = files.arm(*arm_path);
    files.require_good();
    const auto readings = files.joints(readings_path, arm->joint_count(), table_options);
    files.require_good();
    test = test_sphere(*arm, *readings, options);
  } else {
    const auto readings = files.points(readings_path, table_options);
    files.require_good();
    test = test_sphere(*readings, options);
  }
  if (!test.ok()) {
    throw NumericalError(
        fmt::format("{}: no sphere fits: {}", readings_path, explain(test.fit.status)));
  }
  const std::string warning = blind_spot_warning(test);
  if (!warning.empty()) {
    files.diagnostics().warning(
        {readings_path, 0, 0}, warning,
        "probe the sphere from several articulations: elbow left and right, "
        "wrist turned, arm near and far");
  }
  return test;
}

}  // namespace armcal
