// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "armcal/io/toml_value.h"
#include "armcal/simulation/error_sources.h"

namespace armcal {

/// Reads the table [errors] of a scenario, to its end: one table per source, called like the member
/// of ErrorSources; `typical = true` in it, or once above them all, starts from typical sizes.
[[nodiscard]] ErrorSources read_error_sources(TomlSection& section, Diagnostics& diagnostics);

/// A source as a scenario may switch it on.
struct ErrorSourceKeys {
  std::string name;
  std::vector<std::string> keys;
};
[[nodiscard]] std::vector<ErrorSourceKeys> error_source_keys();

}  // namespace armcal
