// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "armcal/verification/probed_sphere.h"
#include "armcal/verification/test_result.h"

namespace armcal::iso10360_12 {

/// Probing size error P_Size.Sph.1x25::Tact.AArm of ISO 10360-12:2016.
///
/// Least-squares diameter of 25 points on a calibrated sphere minus the certified diameter, at each
/// of two positions of the sphere in the volume; the one of larger magnitude is reported with its
/// sign. From public descriptions of the standard: 25 points, the least-squares diameter, two
/// positions, the worse counts. Where the positions and the points lie is not checked.
/// theory/verification.md eq. (1)
/// @throws std::invalid_argument as `probe_sphere`
[[nodiscard]] TestResult probing_size(std::span<const SpherePoints> positions,
                                      const ReferenceSphere& sphere);

}  // namespace armcal::iso10360_12
