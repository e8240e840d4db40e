// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace armcal {

/// The unit in which people read a parameter of a document: lengths in mm, angles in deg, harmonics
/// (amplitudes of an error of an encoder) in urad.
struct ShownUnit {
  double factor = 1.0;  ///< from the unit of the document
  std::string unit;
};
/// @param unit  of the document: "mm" or "rad"
[[nodiscard]] ShownUnit shown_unit(std::string_view parameter, std::string_view unit);

/// A count, without decimals.
[[nodiscard]] std::string whole(double count);

/// An angle that people set: whole degrees where they are whole, else tenths.
[[nodiscard]] std::string set_angle_text(double deg);

/// A condition number; a dash where it is not finite, which a document has as null.
[[nodiscard]] std::string condition_text(const std::optional<double>& condition_number);

/// Units as they are written where every letter can be: "30 um + L/40" gives "30 \u00b5m + L/40".
[[nodiscard]] std::string with_micro_sign(std::string text);

}  // namespace armcal
