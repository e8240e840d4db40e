// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/core/utc_time.h"
#include "armcal/report/document.h"
#include "armcal/verification/check_trend.h"
#include "armcal/verification/interim_check.h"

namespace armcal {

/// A check, its place in the history, or both.
struct CheckSummary {
  std::string arm;       ///< name; may be empty
  std::string artefact;  ///< may be empty
  UtcSeconds time = 0;
  InterimCheckOptions options;  ///< of the check: certified values, tip
  std::optional<double> temperature_C;
  std::string note;
  std::optional<InterimCheck> check;   ///< nothing where only the history was asked for
  std::optional<std::string> history;  ///< its file
  std::optional<std::int64_t> saved;   ///< number of the check, once it is safe
  std::vector<CheckTrend> trends;      ///< of the values that are watched
};

/// Keys: docs/commands/check.md.
[[nodiscard]] Json json_result(const CheckSummary& summary);
[[nodiscard]] std::string text_result(const CheckSummary& summary);

/// What the last check of a trend should make a user do something about: broken rules, a drift.
[[nodiscard]] std::vector<std::string> warnings_of(const CheckTrend& trend);

}  // namespace armcal
