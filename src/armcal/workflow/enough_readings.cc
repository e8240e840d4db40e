// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/enough_readings.h"

#include <fmt/format.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/identification/residuals/residual.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/observations/empty_group.h"

namespace armcal {
namespace {

bool has_priors(const CalibrationOptions& options) {
  return options.prior_length_mm || options.prior_zero_rad || options.prior_twist_rad ||
         options.prior_harmonic_rad || !options.prior_of.empty();
}

// Parameters that many points anywhere would determine.
int knowable_parameters(const ArmModel& nominal, const CalibrationOptions& options) {
  const int count = 20 * nominal.joint_count();  // some three times as many equations as unknowns
  const ForwardKinematics kinematics(nominal);
  RandomStream random(1);
  ObservationGroup group =
      empty_group(ReferenceKind::reference_points, "anywhere", count, nominal.joint_count(), 1.0);
  group.place.assign(static_cast<std::size_t>(count), "anywhere");
  group.reference_mm.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (double& angle : group.encoder_rad.col(i)) angle = random.uniform(-3.0, 3.0);
    group.reference_mm.col(i) = kinematics.tip_in_base(as_span(group.encoder_rad.col(i)));
  }
  constexpr int kFrame = 6;
  return identifiability(nominal, {&group, 1}, options).rank - kFrame;
}

}  // namespace

std::optional<std::string> too_few_readings(std::span<const ObservationGroup> groups,
                                            const ArmModel& nominal,
                                            const CalibrationOptions& options) {
  Unknowns unknowns(nominal, {});
  Eigen::Index equations = 0;
  Eigen::Index readings = 0;
  for (const ObservationGroup& group : groups) {
    for (const auto& residual : residuals_of(group, false, unknowns)) {
      equations += residual->count() * residual->rows_per_observation();
      readings += residual->count();
    }
  }
  if (readings == 0 || has_priors(options)) return std::nullopt;
  const int arm = knowable_parameters(nominal, options);
  const int places = unknowns.step_size();
  if (equations >= arm + places) return std::nullopt;
  return fmt::format(
      "{} readings are too few: they give {} equations for {} unknowns, {} of the arm and {} of "
      "frames and points",
      readings, equations, arm + places, arm, places);
}

}  // namespace armcal
