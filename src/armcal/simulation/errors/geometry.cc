// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/errors/geometry.h"

#include <cmath>

#include "armcal/arm/estimability.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/core/units.h"

namespace armcal {
namespace {

double spread(const Parameter& parameter, const GeometryErrors& errors) {
  switch (parameter.kind) {
    case ParameterKind::zero:
      return errors.u_zero_rad;
    case ParameterKind::alpha:
    case ParameterKind::beta:
      return errors.u_twist_rad;
    case ParameterKind::cosine:
    case ParameterKind::sine:
      return 0.0;
    default:
      return std::abs(parameter.nominal) < 1.0 ? errors.u_offset_mm : errors.u_length_mm;
  }
}

}  // namespace

GeometryErrors GeometryErrors::typical() {
  return {.u_twist_rad = radians_from_degrees(0.025),
          .u_zero_rad = radians_from_degrees(0.025),
          .u_offset_mm = 0.03,
          .u_length_mm = 0.25};
}

ArmModel drawn_arm(const ArmModel& nominal, const GeometryErrors& errors, RandomStream& random) {
  const ParameterTable table(nominal);
  Eigen::VectorXd values = table.nominal();
  for (int i = 0; i < table.size(); ++i) {
    if (held_by_convention(nominal, table[i])) continue;
    values(i) += spread(table[i], errors) * random.normal();
  }
  return with_parameter_values(nominal, values);
}

}  // namespace armcal
