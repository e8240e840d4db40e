// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal {

// The equations of the paper that this procedure comes from, for its arm (ROMER Infinite 2.0):
// Wang, Wang, Lu, Zhang, Trans. Chinese Soc. Agric. Machinery 47(6), 2016, 408-412,
// doi:10.6041/j.issn.1000-1298.2016.06.054. Its equations (6) to (8) are lost in print; these are
// recovered from its Tables 1 and 2 and agree with them to 0.001 mm. theory/symmetric_point.md eq.
// (14)-(19).

/// Table 1: distances between symmetric points, and the radius of the circle about the last axis,
/// mm.
struct Wang2016Readings {
  double l_PP1 = 0.0;  ///< joint 5, theta6 = -+90 deg
  double l_PP2 = 0.0;  ///< joint 5, theta6 = 0
  double l_PP3 = 0.0;  ///< joint 3, all 0
  double l_PP4 = 0.0;  ///< joint 3, theta4 = 90, theta6 = -+90 deg
  double l_PP5 = 0.0;  ///< joint 1, theta2 = 90, theta4 = 90, theta5 = 180, theta6 = -+90 deg
  double R = 0.0;      ///< joint 6
};

/// Table 2, magnitudes, mm.
struct Wang2016Parameters {
  double a5 = 0.0;
  double a7 = 0.0;
  double b3 = 0.0;
  double b5 = 0.0;
  double b7 = 0.0;
  double d7 = 0.0;
};

/// The chain read with the model: the tip arm l_PP1/2 is b7, d7 is 0, and R checks a7 and b7.
[[nodiscard]] Wang2016Parameters consistent_chain(const Wang2016Readings& readings);

/// The chain as printed: b7 = R and d7 = l_PP1/2, the same length counted twice.
[[nodiscard]] Wang2016Parameters literal_chain(const Wang2016Readings& readings);

}  // namespace armcal
