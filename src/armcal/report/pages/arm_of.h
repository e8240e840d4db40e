// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "armcal/arm/arm_model.h"
#include "armcal/report/html/document_view.h"

namespace armcal {

/// The arm whose file (TOML) a document has under a key. @throws InputError where it is no arm
[[nodiscard]] ArmModel arm_of(const DocumentView& document, std::string_view key);

}  // namespace armcal
