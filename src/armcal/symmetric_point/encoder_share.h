// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/arm/arm_model.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// How often the encoders were read at each end of a half turn.
struct EncoderRepeats {
  int at_posture = 1;
  /// 0: they were not read there; the locked joints are taken to stand as before, and the joint
  /// that turns a half turn on.
  int at_end = 0;
};

/// What the uncertainty of the encoders adds to that of a half turn or circle, mm: the arm stood
/// where the encoders say, to their uncertainty only. Readings of an encoder are independent of
/// each other. theory/symmetric_point.md eq. (27). A zero search has none: its angle is read from a
/// wave through many settings, whose scatter shows it.
/// @param u_encoder_rad  standard uncertainty of one reading of one encoder
[[nodiscard]] double u_from_encoders(const ArmModel& arm, const SymmetricReading& reading,
                                     double u_encoder_rad, const EncoderRepeats& repeats);

}  // namespace armcal
