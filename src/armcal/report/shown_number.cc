// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/shown_number.h"

#include <fmt/format.h>

#include "armcal/core/units.h"

namespace armcal {

ShownUnit shown_unit(std::string_view parameter, std::string_view unit) {
  if (unit == "mm") return {1.0, "mm"};
  const bool harmonic = parameter.rfind("cos", 0) == 0 || parameter.rfind("sin", 0) == 0;
  if (harmonic) return {1e6, "urad"};
  return {degrees_from_radians(1.0), "deg"};
}

std::string whole(double count) { return fmt::format("{:.0f}", count); }

}  // namespace armcal
