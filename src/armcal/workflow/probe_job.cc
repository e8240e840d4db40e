// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/probe_job.h"

#include <fmt/format.h>

#include "armcal/core/units.h"

namespace armcal {
namespace {

constexpr const char* kHowToSpread =
    "turn every joint of the wrist between readings: stylus up and down, left and right";

void check_count(const JointReadings& readings, bool on_sphere, Diagnostics& diagnostics) {
  const int least = on_sphere ? kLeastOnSphere : kLeastInSeat;
  const int advised = on_sphere ? kAdvisedOnSphere : kAdvisedInSeat;
  const std::string what =
      fmt::format("{} reading{} {}", readings.count(), readings.count() == 1 ? "" : "s",
                  on_sphere ? "on the sphere" : "in the seat");
  if (readings.count() < least) {
    diagnostics.error({readings.file, 0, 0}, fmt::format("{}: at least {} are needed", what, least),
                      fmt::format("better {}, in very different postures", advised));
  } else if (readings.count() < advised) {
    diagnostics.warning({readings.file, 0, 0}, fmt::format("{}: {} are advised", what, advised));
  }
}

ObservationGroup group_of(const JointReadings& readings, const ProbeRequest& request) {
  ObservationGroup group;
  group.name = "stylus";
  group.kind = request.sphere_diameter_mm ? ReferenceKind::sphere : ReferenceKind::fixed_point;
  group.file = readings.file;
  group.lines = readings.lines;
  group.is_check.assign(readings.lines.size(), false);
  group.u_mm = Eigen::VectorXd::Constant(readings.count(), request.u_mm);
  group.u_encoder_rad = request.u_encoder_rad;
  group.encoder_rad = readings.encoder_rad;
  group.place.assign(readings.lines.size(), "reference");
  if (request.sphere_diameter_mm) group.radius_mm = *request.sphere_diameter_mm / 2.0;
  group.tip_radius_mm = request.tip_diameter_mm / 2.0;
  return group;
}

std::string swing_in_words(const TipCoordinate& each) {
  return fmt::format("the direction of {} swings by no more than {:.1f} deg over the readings",
                     each.parameter, degrees_from_radians(each.swing_rad));
}

void check_spread(const StylusQualification& stylus, const std::string& file,
                  Diagnostics& diagnostics) {
  constexpr double kLittle_deg = 20.0;
  for (const TipCoordinate& each : stylus.tip) {
    if (!each.determined) {
      throw NumericalError(fmt::format("{}: the readings do not determine {}: {}\n  help: {}", file,
                                       fmt::join(stylus.undetermined(), ", "), swing_in_words(each),
                                       kHowToSpread));
    }
    if (degrees_from_radians(each.swing_rad) < kLittle_deg)
      diagnostics.warning({file, 0, 0}, swing_in_words(each), kHowToSpread);
  }
}

}  // namespace

StylusQualification run_probe(InputFiles& files, const ProbeRequest& request,
                              const TableOptions& options) {
  const auto arm = files.arm(request.arm);
  files.require_good();
  const auto readings = files.joints(request.readings, arm->joint_count(), options);
  files.require_good();
  check_count(*readings, request.sphere_diameter_mm.has_value(), files.diagnostics());
  files.require_good();
  StylusQualification stylus = qualify_stylus(*arm, group_of(*readings, request), files.monitor());
  const Calibration& calibration = stylus.calibration;
  if (!calibration.ok() && calibration.status != CalibrationStatus::nothing_determined) {
    throw NumericalError(
        fmt::format("{}: {}", request.readings,
                    calibration.detail.empty() ? explain(calibration.status) : calibration.detail));
  }
  check_spread(stylus, request.readings, files.diagnostics());
  return stylus;
}

}  // namespace armcal
