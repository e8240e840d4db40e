// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/wang2016.h"

namespace armcal {

Wang2016Parameters consistent_chain(const Wang2016Readings& readings) {
  Wang2016Parameters p;
  p.b7 = readings.l_PP1 / 2.0;
  p.a7 = readings.l_PP2 / 2.0;
  p.a5 = readings.l_PP3 / 2.0 + p.a7;
  p.b5 = readings.l_PP4 / 2.0 - p.a7;
  p.b3 = readings.l_PP5 / 2.0 + p.b7 - p.a5;
  p.d7 = 0.0;
  return p;
}

Wang2016Parameters literal_chain(const Wang2016Readings& readings) {
  Wang2016Parameters p = consistent_chain(readings);
  p.d7 = p.b7;
  p.b7 = readings.R;
  return p;
}

}  // namespace armcal
