// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/clearance.h"
#include "armcal/cli/command.h"
#include "armcal/planning/half_turn_candidates.h"

namespace armcal::cli {

/// The flags by which a user says what stands around an arm and where it is measured.
struct RoomFlags {
  std::optional<std::string> volume;
  std::optional<double> column_radius_mm, column_top_mm, bench_mm;

  /// @param volume_help  what lies inside the box
  [[nodiscard]] std::vector<Argument> arguments(const std::string& volume_help);
  [[nodiscard]] Surroundings surroundings() const;
  /// @throws std::invalid_argument for a --volume that is no box
  [[nodiscard]] std::optional<MeasuringVolume> measuring_volume() const;
};

/// "1,3,5" @throws std::invalid_argument naming the flag and what is no number
[[nodiscard]] std::vector<double> numbers_of(const char* flag, const std::string& text);

}  // namespace armcal::cli
