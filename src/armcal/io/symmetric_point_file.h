// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "armcal/arm/arm_model.h"
#include "armcal/core/diagnostics.h"
#include "armcal/io/text_file.h"
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// Reads a *.symmetric.toml (schema armcal.symmetric/1: docs/files/symmetric.md). Readings that
/// name a file stay raw and without points; their `raw->file` is the path, resolved from the place
/// of this file. Whether the readings suit an arm is checked by `check_against_arm`. Problems go to
/// `diagnostics`; with errors nothing is returned.
[[nodiscard]] std::optional<SymmetricPointProcedure> read_symmetric_point_file(
    const TextFile& file, Diagnostics& diagnostics);

/// Checks names, joints and postures of the procedure against the arm that it is about, and
/// completes what depends on it (the posture of a circle about the last axis, which needs none).
/// Complains with the place of each reading. Returns false where anything is wrong.
bool check_against_arm(SymmetricPointProcedure& procedure, const ArmModel& arm,
                       Diagnostics& diagnostics);

}  // namespace armcal
