// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "armcal/core/random.h"

namespace armcal {

/// Readings that are simply wrong: a probe that did not seat, a chip on a sphere. Each reading is
/// one with the same probability; the tip is then `size_mm` away, in any direction, from where the
/// reading has it. theory/virtual_arm.md eq. (15)
struct Blunders {
  double share = 0.0;  ///< of all readings, 0 to 1
  double size_mm = 0.0;

  [[nodiscard]] bool is_on() const { return share > 0.0 && size_mm > 0.0; }
  /// One in a hundred, 0.1 mm: small enough to hide in a table, large enough to spoil a result.
  [[nodiscard]] static Blunders typical();
};

/// How far one reading is off: zero for all but a few.
[[nodiscard]] Eigen::Vector3d drawn_blunder(const Blunders& blunders, RandomStream& random);

}  // namespace armcal
