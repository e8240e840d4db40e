// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "armcal/verification/probed_sphere.h"
#include "armcal/verification/test_result.h"

namespace armcal::iso10360_12 {

/// Articulated location error L_Dia.5x5:Art:Tact.AArm of ISO 10360-12:2016.
///
/// The same sphere, which does not move, is probed with 5 points in each of 5 articulations of the
/// arm. Each set gives a centre (least squares, radius free); the size of the cloud of the five
/// centres is reported. Public descriptions give 5 x 5 and the purpose; that the size is the
/// diameter of the smallest sphere that contains the centres is our reading. The parts are the
/// centres' distances from the middle of that sphere. theory/verification.md eq. (3)
/// @throws std::invalid_argument as `probe_sphere`
[[nodiscard]] TestResult articulated_location(std::span<const SpherePoints> articulations,
                                              const ReferenceSphere& sphere);

}  // namespace armcal::iso10360_12
