// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/observations/symmetric_point_readings.h"

namespace armcal {

std::string_view to_string(SymmetricKind kind) {
  switch (kind) {
    case SymmetricKind::reversal:
      return "reversal";
    case SymmetricKind::circle_radius:
      return "circle_radius";
    case SymmetricKind::zero_search:
      return "zero_search";
  }
  return "unknown";
}

}  // namespace armcal
