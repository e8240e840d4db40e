// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/prediction_job.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/identification/calibration.h"

namespace armcal {

SavedCalibration load_calibration(InputFiles& files, const std::string& path) {
  const auto file = files.text(path, kLargestConfiguration_bytes);
  files.require_good();
  if (!looks_like_json(*file)) {
    files.diagnostics().error(
        {path, 0, 0}, "is no calibration: it has no covariance",
        "give what armcal calibrate --save wrote; for tips alone there is armcal fk");
  }
  files.require_good();
  auto saved = read_calibration(*file, files.diagnostics());
  files.require_good();
  return std::move(*saved);
}

PredictedTips predict_tips(InputFiles& files, const std::string& calibration_path,
                           const std::string& angles_path, const TableOptions& options) {
  const SavedCalibration saved = load_calibration(files, calibration_path);
  const auto readings = files.joints(angles_path, saved.arm.joint_count(), options);
  files.require_good();
  const ForwardKinematics kinematics(saved.arm);
  PredictedTips predicted{Eigen::Matrix3Xd(3, readings->count()),
                          Eigen::Matrix3Xd(3, readings->count())};
  for (Eigen::Index i = 0; i < readings->count(); ++i) {
    predicted.tips_mm.col(i) = kinematics.tip_in_base(readings->posture(i));
    predicted.u_mm.col(i) =
        tip_covariance(saved.arm, saved.free, saved.covariance, readings->posture(i))
            .diagonal()
            .cwiseMax(0.0)
            .cwiseSqrt();
  }
  return predicted;
}

std::string predicted_csv(const PredictedTips& predicted) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "x_mm,y_mm,z_mm,u_x_mm,u_y_mm,u_z_mm\n");
  for (Eigen::Index i = 0; i < predicted.tips_mm.cols(); ++i) {
    const Eigen::Vector3d tip = predicted.tips_mm.col(i);
    const Eigen::Vector3d u = predicted.u_mm.col(i);
    fmt::format_to(std::back_inserter(text), "{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", tip.x(),
                   tip.y(), tip.z(), u.x(), u.y(), u.z());
  }
  return fmt::to_string(text);
}

std::vector<ParameterChange> changes_between(InputFiles& files, const std::string& before,
                                             const std::string& after) {
  const SavedCalibration one = load_calibration(files, before);
  const SavedCalibration other = load_calibration(files, after);
  bool same = one.parameters.size() == other.parameters.size();
  for (std::size_t i = 0; same && i < one.parameters.size(); ++i) {
    same = one.parameters[i].name == other.parameters[i].name;
  }
  if (!same) {
    files.diagnostics().error({after, 0, 0}, fmt::format("has other parameters than {}", before),
                              "only calibrations of the same arm with as many harmonics compare");
  }
  files.require_good();
  std::vector<ParameterChange> changes;
  for (std::size_t i = 0; i < one.parameters.size(); ++i) {
    const SavedParameter& a = one.parameters[i];
    const SavedParameter& b = other.parameters[i];
    ParameterChange change{
        a.name, a.unit, a.value, b.value, std::hypot(a.u, b.u), 0.0, a.is_held != b.is_held};
    if (change.u > 0.0) {
      change.ratio = (b.value - a.value) / change.u;
    } else if (a.value != b.value) {
      change.ratio = std::copysign(std::numeric_limits<double>::infinity(), b.value - a.value);
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace armcal
