// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/observations/empty_group.h"

namespace armcal {

ObservationGroup empty_group(ReferenceKind kind, const std::string& name, int count,
                             int joint_count, double u_mm) {
  ObservationGroup group;
  group.kind = kind;
  group.name = name;
  group.file = name + ".csv";
  for (int i = 0; i < count; ++i) group.lines.push_back(i + 2);
  group.is_check.assign(static_cast<std::size_t>(count), false);
  group.u_mm = Eigen::VectorXd::Constant(count, u_mm > 0.0 ? u_mm : 0.001);
  group.encoder_rad.resize(joint_count, count);
  return group;
}

}  // namespace armcal
