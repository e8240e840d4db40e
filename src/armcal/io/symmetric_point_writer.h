// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

/// Gives every reading without value and without file a file for its points, after its name ("zero
/// 6" is zero-6.csv), beside the file of the procedure.
void name_point_files(SymmetricPointProcedure& procedure);

/// The text of a *.symmetric.toml that `read_symmetric_point_file` reads back as the same
/// procedure. A planned reading, which has neither value nor points yet, names the file that its
/// points will come in (`name_point_files`). Paths are written relative to `procedure.file`.
/// @throws std::invalid_argument where claims of one unit differ in uncertainty: a file has one for
/// all
[[nodiscard]] std::string symmetric_point_text(const SymmetricPointProcedure& procedure,
                                               const std::string& name = {},
                                               const std::string& note = {});

/// The table of the points of a raw reading (docs/files/symmetric.md), as `symmetric_points` reads
/// it; of a planned one the header alone, to be filled in.
[[nodiscard]] std::string raw_points_csv(const SymmetricReading& reading);

}  // namespace armcal
