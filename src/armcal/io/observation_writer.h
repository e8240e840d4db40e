// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/io/session_file.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// How a group of readings is split between its entry in a session and its tables. What all rows
/// share is said once in the entry, the rest by columns. A single length stands in the entry alone.
struct GroupTexts {
  SessionGroup entry;        ///< its files are named after `group.file`
  std::string readings_csv;  ///< for entry.file; empty where that is
  std::string artefact_csv;  ///< for entry.artefact_file; empty where that is
};

/// Texts that `observation_group` reads back as the same group: numbers to the digits of
/// csv_text.h, uncertainties that differ by row to six figures.
/// @throws std::invalid_argument where no table can say it: half turns of several sizes or with
/// other joints moving, one feature with two coordinates, names with quotation marks
[[nodiscard]] GroupTexts group_texts(const ObservationGroup& group);

}  // namespace armcal
