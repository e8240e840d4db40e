// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace armcal {

/// Largest error that a specification allows (VIM 4.26), in one of the three forms of the ISO 10360
/// series, which QIF 3 encodes as well. theory/verification.md eq. (5)
///
/// Written as on data sheets: A and B in micrometres, K without unit, L in millimetres.
class MaximumPermissibleError {
 public:
  /// The same for every length. @throws std::invalid_argument unless A is finite and positive
  [[nodiscard]] static MaximumPermissibleError constant(double a_mm);
  /// A + L/K: 0.020 mm and 50 are "20 um + L/50". @throws std::invalid_argument unless A is finite
  /// and not negative, K finite and positive
  [[nodiscard]] static MaximumPermissibleError linear(double a_mm, double k);
  /// The smaller of A + L/K and B. @throws std::invalid_argument as above, and unless B is finite
  /// and larger than A: otherwise it would be a constant in disguise
  [[nodiscard]] static MaximumPermissibleError lesser(double a_mm, double k, double b_mm);

  /// @throws std::invalid_argument for a length that is negative or not finite
  [[nodiscard]] double at(double length_mm) const;
  [[nodiscard]] bool depends_on_length() const { return k_.has_value(); }
  /// "30 um", "20 um + L/50", "min(20 um + L/50, 80 um)".
  [[nodiscard]] std::string text() const;

 private:
  MaximumPermissibleError(double a_mm, std::optional<double> k, std::optional<double> b_mm)
      : a_mm_(a_mm), k_(k), b_mm_(b_mm) {}

  double a_mm_;
  std::optional<double> k_;
  std::optional<double> b_mm_;
};

}  // namespace armcal
