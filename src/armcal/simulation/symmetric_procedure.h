// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/core/units.h"
#include "armcal/observations/symmetric_point_readings.h"
#include "armcal/simulation/laboratory.h"

namespace armcal {

/// How carefully the symmetric-point procedure is carried out.
struct SymmetricPractice {
  double u_point_mm = 0.002;  ///< of each coordinate that the reference machine measures
  int repeats = 5;            ///< points at each end of a half turn
  int arc_points = 12;        ///< of a circle, over arc_rad
  double arc_rad = radians_from_degrees(120.0);
  int zero_settings = 7;  ///< of a searched joint, over zero_range_rad about where it is sought
  double zero_range_rad = radians_from_degrees(150.0);
  double u_posture_rad = radians_from_degrees(0.5);  ///< how well postures are set by hand
  double u_slip_rad = 0.0;                           ///< of each locked joint between the two ends
  double u_half_turn_rad = 0.0;                      ///< by which a half turn is not quite 180 deg
};

/// Carries out a planned procedure: what it keeps are names, kinds, joints and postures of the
/// readings; what it adds are raw points as the reference machine gives them, in its own frame,
/// with the encoder readings at each.
/// @throws Impossible naming the reading whose posture the arm cannot take
[[nodiscard]] SymmetricPointProcedure carry_out(Laboratory& laboratory,
                                                const SymmetricPointProcedure& plan,
                                                const SymmetricPractice& practice);

/// The procedure of the 2016 paper for an arm with its axes: zero searches of joints 2, 4, 6, the
/// five half turns and the circle of Table 1, each with the parameter that the chain takes from it.
/// Wang, Wang, Lu, Zhang 2016, section 2.
[[nodiscard]] SymmetricPointProcedure wang2016_procedure();

}  // namespace armcal
