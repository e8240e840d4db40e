// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/robust_loss.h"

#include <cmath>

namespace armcal {

LossAndWeight robust_loss(RobustLoss loss, double squared, double scale) {
  const double knee = scale * scale;
  switch (loss) {
    case RobustLoss::none:
      break;
    case RobustLoss::huber: {
      if (squared <= knee) break;
      const double length = std::sqrt(squared);
      return {2.0 * scale * length - knee, scale / length};
    }
    case RobustLoss::cauchy:
      return {knee * std::log1p(squared / knee), 1.0 / (1.0 + squared / knee)};
  }
  return {squared, 1.0};
}

}  // namespace armcal
