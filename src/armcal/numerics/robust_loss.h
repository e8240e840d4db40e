// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace armcal {

enum class RobustLoss { none, huber, cauchy };

/// What an observation of squared length `squared` adds to the cost, and the weight of its rows.
struct LossAndWeight {
  double loss = 0.0;    ///< squared itself while that is small against scale^2
  double weight = 1.0;  ///< derivative of the loss by `squared`
};

/// theory/least_squares.md eq. (17) and (18). The gradient of the loss is that of the weighted
/// squares, so reweighted rows lead to the exact minimum of the loss.
/// @param squared  sum of the squared residuals of one observation
/// @param scale    length from which an observation loses influence, in the units of a residual
[[nodiscard]] LossAndWeight robust_loss(RobustLoss loss, double squared, double scale);

}  // namespace armcal
