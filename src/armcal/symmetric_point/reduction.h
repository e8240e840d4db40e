// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/core/diagnostics.h"
#include "armcal/geometry/circle.h"
#include "armcal/observations/symmetric_point_readings.h"
#include "armcal/symmetric_point/zero_search.h"

namespace armcal {

/// Repeated points at one end of a half turn.
struct EndStatistics {
  int count = 0;
  Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
  /// Experimental standard deviation of one point along the line between the ends; 0 for a single
  /// point.
  double s_mm = 0.0;
};

/// How a raw reading became a value: what a report shows beside it.
struct Reduction {
  std::string reading;
  // reversal
  std::optional<EndStatistics> end_a;
  std::optional<EndStatistics> end_b;
  double half_turn_rad = 0.0;  ///< by the encoders where they were recorded, else pi
  double largest_slip_rad =
      0.0;  ///< of a locked joint between the ends; 0 without encoder readings
  // circle_radius
  std::optional<CircleFit> arc;
  // zero_search
  std::vector<RadiusAtSetting> radii;
  std::optional<ZeroSearchResult> zero;
  /// Standard uncertainty from repeats or scatter alone (type A), same unit as the value; 0 where
  /// there is none.
  double u_type_a = 0.0;
};

/// Turns raw points into the value and standard uncertainty of the reading, and the postures into
/// those that the encoders recorded. The `u` that the file gives a raw reading is what repeats
/// cannot show (type B); it is added in quadrature. Problems (one point per end and no u, an arc
/// that is no arc) go to `diagnostics` at the place of the reading; then nothing is returned.
/// Points far off the others of their kind, and locked joints that moved, are warned of. Reduced
/// readings pass through unchanged. theory/symmetric_point.md eq. (20)-(24).
struct ReducedReading {
  SymmetricReading reading;
  Reduction reduction;
};
[[nodiscard]] std::optional<ReducedReading> reduce(const SymmetricReading& reading,
                                                   const ArmModel& nominal,
                                                   Diagnostics& diagnostics);

}  // namespace armcal
