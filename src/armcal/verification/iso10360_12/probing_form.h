// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "armcal/verification/probed_sphere.h"
#include "armcal/verification/test_result.h"

namespace armcal::iso10360_12 {

/// Probing form error P_Form.Sph.1x25::Tact.AArm of ISO 10360-12:2016.
///
/// Thickness of the shell about the least-squares centre that holds all 25 points (largest minus
/// smallest radius), at each of two positions of the sphere; the larger counts. From public
/// descriptions of the standard, all of it. Fewer than five points contradict no sphere: such a
/// position gives no form. theory/verification.md eq. (2)
/// @throws std::invalid_argument as `probe_sphere`
[[nodiscard]] TestResult probing_form(std::span<const SpherePoints> positions,
                                      const ReferenceSphere& sphere);

}  // namespace armcal::iso10360_12
