// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/probe_job.h"

#include <fmt/format.h>

namespace armcal {
namespace {

// Everything but the tip.
std::vector<std::string> names_to_hold(const ArmModel& arm) {
  std::vector<std::string> names;
  const ParameterTable table(arm);
  for (const Parameter& parameter : table.parameters()) {
    const bool of_tip = parameter.kind == ParameterKind::tip_a ||
                        parameter.kind == ParameterKind::tip_b ||
                        parameter.kind == ParameterKind::tip_d;
    if (!of_tip) names.push_back(parameter.name);
  }
  return names;
}

}  // namespace

Calibration run_probe(InputFiles& files, const ProbeRequest& request, const TableOptions& options) {
  const auto arm = files.arm(request.arm);
  files.require_good();
  const auto readings = files.joints(request.readings, arm->joint_count(), options);
  files.require_good();
  ObservationGroup group;
  group.name = "stylus";
  group.kind = request.sphere_diameter_mm ? ReferenceKind::sphere : ReferenceKind::fixed_point;
  group.file = readings->file;
  group.lines = readings->lines;
  group.is_check.assign(readings->lines.size(), false);
  group.u_mm = Eigen::VectorXd::Constant(readings->count(), request.u_mm);
  group.encoder_rad = readings->encoder_rad;
  group.place.assign(readings->lines.size(), "reference");
  if (request.sphere_diameter_mm) group.radius_mm = *request.sphere_diameter_mm / 2.0;
  group.tip_radius_mm = request.tip_diameter_mm / 2.0;
  CalibrationOptions calibration_options;
  calibration_options.hold = names_to_hold(*arm);
  calibration_options.monitor = files.monitor();
  Calibration calibration = calibrate(*arm, {&group, 1}, calibration_options);
  if (!calibration.ok()) {
    throw NumericalError(
        fmt::format("{}: {}", request.readings,
                    calibration.detail.empty() ? explain(calibration.status) : calibration.detail));
  }
  return calibration;
}

}  // namespace armcal
