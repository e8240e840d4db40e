// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace armcal {

/// Seconds since 1970-01-01T00:00:00Z, without leap seconds.
using UtcSeconds = std::int64_t;

/// ISO 8601: "2026-03-02", "2026-03-02T09:15", "2026-03-02 09:15:30Z", "2026-03-02T10:15+01:00";
/// UTC where no zone is given. Years 1970 to 9999. Nothing where the text is no such time.
[[nodiscard]] std::optional<UtcSeconds> parse_utc_time(std::string_view text);

/// "2026-03-02T09:15:30Z"
[[nodiscard]] std::string utc_text(UtcSeconds time);

/// The same forms, and with a fraction after the seconds: "2026-03-02T10:15:30.25+01:00".
[[nodiscard]] std::optional<double> parse_fractional_utc_time(std::string_view text);

/// To the millisecond: "2026-03-02T09:15:30.250Z"; without a fraction where there is none.
/// @param time_s  not negative
[[nodiscard]] std::string fractional_utc_text(double time_s);

}  // namespace armcal
