// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "armcal/arm/dh_table.h"
#include "armcal/core/diagnostics.h"
#include "armcal/io/csv_table.h"
#include "armcal/io/text_file.h"

namespace armcal {

/// Reads a D-H table file (*.dh.toml, schema armcal.dh/1: docs/files/dh.md): convention, one
/// [[row]] for each joint (theta_deg, d_mm, a_mm, alpha_deg), optional [base] and [tool]. Problems
/// go to `diagnostics`.
[[nodiscard]] std::optional<DhTable> read_dh(const TextFile& file, Diagnostics& diagnostics);

/// Reads a D-H table as people keep it in a spreadsheet: columns theta, d, a, alpha with units. The
/// convention is not in the file and must be told.
[[nodiscard]] std::optional<DhTable> dh_from_csv(const CsvTable& table, DhConvention convention,
                                                 Diagnostics& diagnostics);

[[nodiscard]] std::string dh_text(const DhTable& table);

/// The spreadsheet form: theta_deg,d_mm,a_mm,alpha_deg. It has no place for base and tool.
[[nodiscard]] std::string dh_csv_text(const DhTable& table);

}  // namespace armcal
