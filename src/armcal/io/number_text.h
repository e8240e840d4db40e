// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armcal {

/// The number that the whole of `text` spells, or nothing. Takes a leading `+`, the Unicode minus
/// sign, and with `decimal_comma` a comma for the point. NaN and infinities are no numbers here.
[[nodiscard]] std::optional<double> parse_number(std::string_view text, bool decimal_comma = false);

/// Does the text spell "not a number" in one of the ways of the trade (nan, n/a, null,
/// inf, 1.#QNAN)?
[[nodiscard]] bool spells_missing(std::string_view text);

/// Shortest text that reads back as the same double, always with a point or exponent: "747.489",
/// "90.0".
[[nodiscard]] std::string shortest_text(double value);

/// Shortest text of the value rounded to so many decimal places: "12.5", "-3", "0".
[[nodiscard]] std::string decimal_text(double value, int places);

/// value * 10^places by moving the decimal point of its shortest text: 0.1273 m is 127.3 mm, which
/// a product of doubles may miss by the last digit.
[[nodiscard]] double with_point_moved(double value, int places);

/// Shortest text in degrees that reads back, through radians_from_degrees, as the same double in
/// radians. For the few radians that no double in degrees maps to, the nearest (2e-16 relative).
[[nodiscard]] std::string degrees_text(double radians);
/// The same in seconds of arc, through radians_from_arcseconds.
[[nodiscard]] std::string arcseconds_text(double radians);

}  // namespace armcal
