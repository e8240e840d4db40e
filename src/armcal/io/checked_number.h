// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/core/diagnostics.h"

namespace armcal {

class TomlSection;

// Numbers of a section within bounds; one out of them is an error where it stands.

/// Larger than 0; `otherwise` where the key is missing.
double positive_or(double otherwise, TomlSection& section, const char* key,
                   Diagnostics& diagnostics);

/// At least 0; 0 where the key is missing.
double not_negative_or_zero(TomlSection& section, const char* key, Diagnostics& diagnostics);

/// A length in mm that must be there, larger than 0 and not longer than any arm.
double required_length(TomlSection& section, const char* key, Diagnostics& diagnostics);

}  // namespace armcal
