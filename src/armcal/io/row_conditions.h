// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/io/csv_table.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// When and at which temperature each row was read: the optional columns `time` (dates as in
/// core/utc_time.h, also with a fraction of a second, or plain numbers of seconds; not both in one
/// table) and `temperature_c`. Empty fields are rows that do not say. docs/files/tables.md
void read_conditions(const CsvTable& table, ObservationGroup& group, Diagnostics& diagnostics);

}  // namespace armcal
