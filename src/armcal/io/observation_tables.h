// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "armcal/io/csv_table.h"
#include "armcal/io/session_file.h"

namespace armcal {

/// The readings of one group of a session. Strict where a mistake would be silent: equal rows,
/// missing points, uncertainties that are not positive, features that the artefact does not have.
/// @param table     of the readings; null for a length that the session gives in place
/// @param artefact  table of calibrated coordinates (feature, x_mm, y_mm, z_mm); null for other
/// kinds
/// @return nothing after an error, which is in `diagnostics`
[[nodiscard]] std::optional<ObservationGroup> observation_group(const SessionGroup& session,
                                                                const CsvTable* table,
                                                                const CsvTable* artefact,
                                                                int joint_count,
                                                                Diagnostics& diagnostics);

}  // namespace armcal
