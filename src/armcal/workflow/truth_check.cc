// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/truth_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/geometry/registration.h"
#include "armcal/simulation/empty_group.h"

namespace armcal {
namespace {

std::vector<Eigen::Vector3d> tips_of(const ArmModel& arm, const Eigen::MatrixXd& encoder_rad) {
  const ForwardKinematics kinematics(arm);
  std::vector<Eigen::Vector3d> tips_mm;
  for (Eigen::Index i = 0; i < encoder_rad.cols(); ++i) {
    tips_mm.push_back(kinematics.tip_in_base(
        {encoder_rad.col(i).data(), static_cast<std::size_t>(encoder_rad.rows())}));
  }
  return tips_mm;
}

std::vector<Eigen::Vector3d> columns_of(const Eigen::Matrix3Xd& points_mm) {
  return {points_mm.colwise().begin(), points_mm.colwise().end()};
}

// So many noiseless points that everything that points can tell is told.
ObservationGroup points_of(const ArmModel& arm) {
  const int count = 25 * arm.joint_count();
  ObservationGroup group =
      empty_group(ReferenceKind::reference_points, "truth", count, arm.joint_count(), 0.0);
  RandomStream random(1);
  for (double& angle : group.encoder_rad.reshaped()) angle = random.uniform(-3.0, 3.0);
  const auto tips_mm = tips_of(arm, group.encoder_rad);
  group.place.assign(tips_mm.size(), "truth");
  group.reference_mm.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    group.reference_mm.col(i) = tips_mm[static_cast<std::size_t>(i)];
  }
  return group;
}

}  // namespace

TruthCheck check_against_truth(const ArmModel& arm, const Simulation& simulation) {
  if (!simulation.check) throw std::invalid_argument("the simulation has no check rows");
  const ObservationGroup& check = *simulation.check;
  const auto true_mm = columns_of(check.reference_mm);
  const auto found_mm = tips_of(arm, check.encoder_rad);
  const Registration fit = register_points(found_mm, true_mm);
  TruthCheck result;
  result.rms_mm = fit.rms_mm;
  result.max_mm = fit.form_mm;
  result.floor_mm = register_points(tips_of(simulation.truth, check.encoder_rad), true_mm).rms_mm;
  result.scale = register_points(found_mm, true_mm, {.estimate_scale = true}).scale - 1.0;
  return result;
}

Eigen::VectorXd true_values(const Calibration& calibration, const ArmModel& truth) {
  CalibrationOptions options;
  for (const CalibratedParameter& parameter : calibration.parameters) {
    if (parameter.status == ParameterStatus::held) options.hold.push_back(parameter.name);
  }
  const ObservationGroup group = points_of(truth);
  // From the found arm: its held values are the convention, and its others are near.
  const Calibration same = calibrate(calibration.arm, {&group, 1}, options);
  Eigen::VectorXd values =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(calibration.parameters.size()),
                                std::numeric_limits<double>::quiet_NaN());
  if (!same.ok()) return values;
  for (const int index : same.free) {
    values(index) = same.parameters[static_cast<std::size_t>(index)].value;
  }
  return values;
}

IntervalCount count_intervals(const Calibration& calibration, const ArmModel& truth) {
  constexpr double k95 = 1.959963984540054;
  const Eigen::VectorXd values = true_values(calibration, truth);
  IntervalCount result;
  for (const int index : calibration.free) {
    if (std::isnan(values(index))) continue;
    const CalibratedParameter& found = calibration.parameters[static_cast<std::size_t>(index)];
    ++result.count;
    if (std::abs(found.value - values(index)) <= k95 * found.u) ++result.inside;
  }
  return result;
}

}  // namespace armcal
