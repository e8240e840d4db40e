// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/true_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armcal/arm/parameter_table.h"
#include "armcal/identification/calibration.h"
#include "armcal/observations/empty_group.h"

namespace armcal {

Eigen::VectorXd true_values(const ArmModel& found, std::span<const int> free,
                            const Eigen::MatrixXd& encoder_rad,
                            std::span<const Eigen::Vector3d> true_mm) {
  const ParameterTable table(found);
  CalibrationOptions options;
  for (int i = 0; i < table.size(); ++i) {
    if (std::ranges::find(free, i) == free.end()) options.hold.push_back(table[i].name);
  }
  const auto count = static_cast<int>(true_mm.size());
  ObservationGroup group =
      empty_group(ReferenceKind::reference_points, "truth", count, found.joint_count(), 0.0);
  group.encoder_rad = encoder_rad;
  group.place.assign(true_mm.size(), "truth");
  group.reference_mm.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    group.reference_mm.col(i) = true_mm[static_cast<std::size_t>(i)];
  }
  // From the found arm: its held values are the convention, and its others are near.
  const Calibration truth = calibrate(found, {&group, 1}, options);
  Eigen::VectorXd values =
      Eigen::VectorXd::Constant(table.size(), std::numeric_limits<double>::quiet_NaN());
  if (!truth.ok()) return values;
  for (const int index : truth.free) {
    values(index) = truth.parameters[static_cast<std::size_t>(index)].value;
  }
  return values;
}

IntervalCount count_intervals(const ArmModel& found, std::span<const int> free,
                              const Eigen::VectorXd& u, const Eigen::VectorXd& true_values) {
  constexpr double k95 = 1.959963984540054;
  const Eigen::VectorXd values = parameter_values(found);
  IntervalCount result;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double true_value = true_values(free[i]);
    if (std::isnan(true_value)) continue;
    ++result.count;
    const double error = values(free[i]) - true_value;
    if (std::abs(error) <= k95 * u(static_cast<Eigen::Index>(i))) ++result.inside;
  }
  return result;
}

}  // namespace armcal
