// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "armcal/verification/probed_sphere.h"
#include "armcal/verification/test_result.h"

namespace armcal::b89_4_22 {

/// Effective diameter of ASME B89.4.22-2004: a calibrated sphere is fitted by nine points, several
/// times.
///
/// Two results: the mean of the diameters minus the certified one (parts: each fit's), and the
/// standard deviation of the diameters (from two fits on). From public descriptions: nine points,
/// mean and standard deviation; that at least three fits are asked for, and least squares, is our
/// reading. theory/verification.md eq. (6)
/// @throws std::invalid_argument as `probe_sphere`
[[nodiscard]] std::vector<TestResult> effective_diameter(std::span<const SpherePoints> fits,
                                                         const ReferenceSphere& sphere);

}  // namespace armcal::b89_4_22
