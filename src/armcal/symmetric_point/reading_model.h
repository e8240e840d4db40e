// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "armcal/arm/arm_model.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// What a reading would be on a given arm, and how it moves with every parameter.
struct ReadingPrediction {
  double value = 0.0;        ///< mm; rad for zero_search
  Eigen::VectorXd gradient;  ///< by every parameter, ParameterTable order
};

/// The readings of the symmetric-point procedure as functions of the model.
/// theory/symmetric_point.md:
///   reversal       eq. (1)  |p(e) - p(e')|
///   circle_radius  eq. (2)  distance of the tip from the axis of the joint
///   zero_search    eq. (3)  the reading of the joint nearest to `reading.value` (unreduced: to the
///   posture) at
///                  which the radius about the axis of the swept joint is extremal
/// Analytic gradients. With the tip on the axis a distance or radius is 0 and has no gradient
/// (NaN); value and gradient are NaN where the reading does not exist: no extremum.
[[nodiscard]] ReadingPrediction predict(const ArmModel& arm, const SymmetricReading& reading);

}  // namespace armcal
