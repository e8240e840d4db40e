// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/forward_kinematics_job.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

void warn_of_limits(const ArmModel& arm, const JointReadings& readings, Diagnostics& diagnostics) {
  for (int joint = 0; joint < arm.joint_count(); ++joint) {
    const Joint& model = arm.joints[static_cast<std::size_t>(joint)];
    int outside = 0;
    Eigen::Index first = 0;
    for (Eigen::Index i = 0; i < readings.count(); ++i) {
      const double reading = readings.encoder_rad(joint, i);
      if (reading >= model.min_rad && reading <= model.max_rad) continue;
      if (outside++ == 0) first = i;
    }
    if (outside == 0) continue;
    diagnostics.warning(
        {readings.file, readings.lines[static_cast<std::size_t>(first)], 0},
        fmt::format("joint {} reads {:.3f} deg, outside its limits{}", joint + 1,
                    degrees_from_radians(readings.encoder_rad(joint, first)),
                    outside == 1 ? "" : fmt::format(" (so do {} more rows)", outside - 1)));
  }
}

// What is beyond is rounding of sines and cosines; a zero has no sign.
double rounded_to_picometres(double mm) { return std::round(mm * 1e9) / 1e9 + 0.0; }

}  // namespace

Eigen::Matrix3Xd compute_tips(InputFiles& files, const std::string& arm_path,
                              const std::string& angles_path, const TableOptions& options) {
  const auto arm = files.arm(arm_path);
  files.require_good();
  TableOptions log_options = options;
  log_options.keep_duplicates = true;  // a log may well repeat a posture
  const auto readings = files.joints(angles_path, arm->joint_count(), log_options);
  files.require_good();
  warn_of_limits(*arm, *readings, files.diagnostics());
  const ForwardKinematics kinematics(*arm);
  Eigen::Matrix3Xd tips(3, readings->count());
  constexpr Eigen::Index kPerReport = 1 << 16;
  for (Eigen::Index i = 0; i < readings->count(); ++i) {
    if (i % kPerReport == 0) {
      files.monitor().report("computing tips",
                             static_cast<double>(i) / static_cast<double>(tips.cols()));
    }
    tips.col(i) = kinematics.tip_in_base(readings->posture(i));
  }
  return tips;
}

std::string tips_csv(const Eigen::Matrix3Xd& tips_mm) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "x_mm,y_mm,z_mm\n");
  for (Eigen::Index i = 0; i < tips_mm.cols(); ++i) {
    const Eigen::Vector3d tip = tips_mm.col(i).unaryExpr(&rounded_to_picometres);
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", tip.x(), tip.y(), tip.z());
  }
  return fmt::to_string(text);
}

}  // namespace armcal
