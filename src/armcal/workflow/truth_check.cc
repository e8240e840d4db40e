// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/truth_check.h"

#include <stdexcept>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/geometry/registration.h"

namespace armcal {
namespace {

std::vector<Eigen::Vector3d> columns_of(const Eigen::Matrix3Xd& points_mm) {
  return {points_mm.colwise().begin(), points_mm.colwise().end()};
}

}  // namespace

TruthCheck check_against_truth(const ArmModel& arm, const Simulation& simulation) {
  if (!simulation.check) throw std::invalid_argument("the simulation has no check rows");
  const ObservationGroup& check = *simulation.check;
  const auto true_mm = columns_of(check.reference_mm);
  const auto found_mm = tips_in_base(arm, check.encoder_rad);
  const Registration fit = register_points(found_mm, true_mm);
  TruthCheck result;
  result.rms_mm = fit.rms_mm;
  result.max_mm = fit.form_mm;
  result.floor_mm =
      register_points(tips_in_base(simulation.truth, check.encoder_rad), true_mm).rms_mm;
  result.scale = register_points(found_mm, true_mm, {.estimate_scale = true}).scale - 1.0;
  return result;
}

Eigen::VectorXd true_values(const Calibration& calibration, const ArmModel& truth) {
  // So many that everything that points can tell is told.
  Eigen::MatrixXd encoder_rad(truth.joint_count(), 25 * truth.joint_count());
  RandomStream random(1);
  for (double& angle : encoder_rad.reshaped()) angle = random.uniform(-3.0, 3.0);
  return true_values(calibration.arm, calibration.free, encoder_rad,
                     tips_in_base(truth, encoder_rad));
}

IntervalCount count_intervals(const Calibration& calibration, const ArmModel& truth) {
  return count_intervals(calibration.arm, calibration.free,
                         calibration.covariance.diagonal().cwiseSqrt(),
                         true_values(calibration, truth));
}

}  // namespace armcal
