// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace armcal {

// Inside the library lengths are millimetres and angles radians, as plain doubles whose names end
// in _mm or _rad. These functions are the only conversions; they are used where files are read and
// results written.

[[nodiscard]] constexpr double radians_from_degrees(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}
[[nodiscard]] constexpr double degrees_from_radians(double radians) {
  return radians * (180.0 / std::numbers::pi);
}
[[nodiscard]] constexpr double radians_from_arcseconds(double arcseconds) {
  return radians_from_degrees(arcseconds / 3600.0);
}
[[nodiscard]] constexpr double arcseconds_from_radians(double radians) {
  return degrees_from_radians(radians) * 3600.0;
}
[[nodiscard]] constexpr double millimetres_from_metres(double metres) { return metres * 1000.0; }
[[nodiscard]] constexpr double metres_from_millimetres(double millimetres) {
  return millimetres / 1000.0;
}
[[nodiscard]] constexpr double millimetres_from_micrometres(double micrometres) {
  return micrometres * 1e-3;
}
[[nodiscard]] constexpr double micrometres_from_millimetres(double millimetres) {
  return millimetres * 1000.0;
}
[[nodiscard]] constexpr double millimetres_from_inches(double inches) { return inches * 25.4; }

}  // namespace armcal
