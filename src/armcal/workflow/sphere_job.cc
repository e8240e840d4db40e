// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/sphere_job.h"

#include <fmt/format.h>

#include "armcal/report/sphere_test_report.h"

namespace armcal {

namespace {

PointReadings coordinates(InputFiles& files, const std::string& path, const TableOptions& options) {
  const auto table = files.table(path, options);
  files.require_good();
  if (!table->find("x") && table->find("q1")) {
    files.diagnostics().error({path, 0, 0}, "holds joint angles, no coordinates",
                              "give the arm that turns them into tips: --arm ARM");
    files.require_good();
  }
  auto readings = point_readings(*table, options, files.diagnostics());
  files.require_good();
  return std::move(*readings);
}

// Four points are one sphere, whatever they are worth.
void check_redundancy(const SphereTest& test, const SphereTestOptions& options,
                      const std::string& path, Diagnostics& diagnostics) {
  if (test.fit.count >= kLeastPointsForForm) return;
  if (options.largest_form_error_mm) {
    throw NumericalError(
        fmt::format("{}: {} points determine a sphere exactly and show no form error to judge\n"
                    "  help: take at least {} points, better 25",
                    path, test.fit.count, kLeastPointsForForm));
  }
  diagnostics.warning(
      {path, 0, 0},
      fmt::format("{} points determine a sphere exactly: nothing checks the diameter",
                  test.fit.count),
      fmt::format("take at least {} points, better 25", kLeastPointsForForm));
}

}  // namespace

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
    test = test_sphere(coordinates(files, readings_path, table_options), options);
  }
  if (!test.ok()) {
    throw NumericalError(
        fmt::format("{}: no sphere fits: {}", readings_path, explain(test.fit.status)));
  }
  check_redundancy(test, options, readings_path, files.diagnostics());
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
