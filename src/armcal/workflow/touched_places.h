// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/verification/interim_check.h"
#include "armcal/workflow/input_files.h"

namespace armcal {

/// The points of a table by the names in its column `point`, in the order in which the names come;
/// all of them one nameless place where there is no such column. Joint angles go through the arm,
/// coordinates are taken as they are. Warns of joints that stood still. @throws InputError
[[nodiscard]] std::vector<TouchedPlace> touched_places(InputFiles& files,
                                                       const std::string& readings,
                                                       const std::optional<ArmModel>& arm,
                                                       const TableOptions& options);

}  // namespace armcal
