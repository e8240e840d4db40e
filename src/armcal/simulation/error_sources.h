// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "armcal/simulation/errors/base_movement.h"
#include "armcal/simulation/errors/bearing_run_out.h"
#include "armcal/simulation/errors/blunders.h"
#include "armcal/simulation/errors/encoder_noise.h"
#include "armcal/simulation/errors/geometry.h"
#include "armcal/simulation/errors/gravity_sag.h"
#include "armcal/simulation/errors/probing_force.h"
#include "armcal/simulation/errors/scale_eccentricity.h"
#include "armcal/simulation/errors/thermal_expansion.h"
#include "armcal/simulation/errors/warm_up_drift.h"

namespace armcal {

/// Everything that makes an arm differ from its drawing, and its readings from what they should be.
/// All off by default.
struct ErrorSources {
  GeometryErrors geometry;
  EncoderNoise encoder_noise;
  ScaleEccentricity scale_eccentricity;
  BearingRunOut bearing_run_out;
  GravitySag gravity_sag;
  ThermalExpansion thermal_expansion;
  ProbingForce probing_force;
  BaseMovement base_movement;
  WarmUpDrift warm_up_drift;
  Blunders blunders;

  /// Where gravity pulls, base frame, of unit length: another one for an arm on a wall.
  Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

  /// All of typical size but blunders, which are no property of an arm.
  [[nodiscard]] static ErrorSources typical();
};

/// One source, for front ends and tables.
struct ErrorSource {
  std::string_view name;   ///< as the member of ErrorSources
  std::string_view brief;  ///< a few words
  bool (*is_on)(const ErrorSources&);
  void (*switch_on)(ErrorSources&);  ///< in its typical size
};

/// All of them, in the order of ErrorSources.
[[nodiscard]] std::span<const ErrorSource> error_source_list();

}  // namespace armcal
