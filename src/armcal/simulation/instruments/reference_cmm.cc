// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/instruments/reference_cmm.h"

#include "armcal/observations/empty_group.h"

namespace armcal {

std::vector<ObservationGroup> measure(Laboratory& laboratory, const ReferenceCmm& cmm) {
  ObservationGroup group = empty_group(ReferenceKind::reference_points, cmm.name, cmm.count,
                                       laboratory.arm().truth().joint_count(), cmm.u_mm);
  const RigidTransform reference_from_base = laboratory.convenient_place(0.0);
  group.reference_mm.resize(3, cmm.count);
  group.place.assign(static_cast<std::size_t>(cmm.count), cmm.name);
  for (int i = 0; i < cmm.count; ++i) {
    const TakenReading taken = laboratory.take(laboratory.free_posture());
    group.encoder_rad.col(i) = taken.encoder_rad;
    group.reference_mm.col(i) = reference_from_base * taken.tip_mm + laboratory.noise(cmm.u_mm);
  }
  return {group};
}

}  // namespace armcal
