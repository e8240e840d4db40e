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
/// readings, and what they solve; what it adds are raw points as the reference machine gives them,
/// in a frame of its own for every reading, with the encoder readings at each. Arcs and settings
/// that a stop cuts off are shifted, hands set no joint beyond a stop, and a half turn without a
/// planned end goes to the side that the stops leave. Uncertainties are for `reduce` to find (`u`
/// is 0; without any noise 1 um, for weights must be finite).
/// @throws Impossible naming the reading whose posture the arm cannot take
[[nodiscard]] SymmetricPointProcedure carry_out(Laboratory& laboratory,
                                                const SymmetricPointProcedure& plan,
                                                const SymmetricPractice& practice);

/// The procedure of the 2016 paper for an arm with its axes: zero searches of joints 2, 4, 6, the
/// five half turns and the circle of Table 1. The chain takes a length from each half turn; zeros
/// of joints 2 and 4 are for the adjustment, which is asked for them too (that of joint 6 turns the
/// tip as a7 and b7 do). Wang, Wang, Lu, Zhang 2016, section 2.
[[nodiscard]] SymmetricPointProcedure wang2016_procedure();

}  // namespace armcal
