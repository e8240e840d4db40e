// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/core/units.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A platform that turns the whole arm to six positions over one fixed gauge (Acero, Brau,
/// Santolaria, Pueo 2015). An arm on such a platform is an arm with one joint more, whose first
/// encoder shows the index: `on_platform` adds it, and everything else treats it as any arm.
struct IndexedPlatform {
  std::string name = "platform";
  int positions = 6;
  int points = 10;      ///< of the fixed gauge, spread around the arm
  int postures = 1;     ///< on each point that is within reach, in each position
  double u_mm = 0.005;  ///< of a coordinate of the gauge
  double u_index_rad = radians_from_arcseconds(0.5);
  double radius_mm = 100.0;  ///< of the arm's first axis from the axis of the platform
};

/// The arm with the platform as its first joint; its remaining joints are those of `arm`.
[[nodiscard]] ArmModel on_platform(const ArmModel& arm, const IndexedPlatform& platform);
/// The arm without its first joint: what stands on the platform.
[[nodiscard]] ArmModel without_platform(const ArmModel& arm_on_platform);

/// Kind artefact, one placement, encoder readings of `on_platform(..)`: the laboratory's arm is the
/// one without platform. @throws Impossible
[[nodiscard]] std::vector<ObservationGroup> measure(Laboratory& laboratory,
                                                    const IndexedPlatform& platform);

}  // namespace armcal
