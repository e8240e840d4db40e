// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/cli/command.h"
#include "armcal/io/reading_tables.h"

namespace armcal::cli {

/// The flags by which a user says how to read a table.
struct TableFlags {
  std::vector<std::string> map;
  std::optional<std::string> angles;
  bool keep_duplicates = false;
  bool keep_zero_points = false;

  [[nodiscard]] std::vector<Argument> for_angles();
  /// What to do with rows that look like mistakes.
  [[nodiscard]] std::vector<Argument> for_suspects();
  [[nodiscard]] std::vector<Argument> for_points();
  /// @throws std::invalid_argument for a --map that is not OURS=THEIRS
  [[nodiscard]] TableOptions options() const;
};

/// Joins lists of arguments.
[[nodiscard]] std::vector<Argument> joined(std::vector<Argument> first,
                                           const std::vector<Argument>& second);

}  // namespace armcal::cli
