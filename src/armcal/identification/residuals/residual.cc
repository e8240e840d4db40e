// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/residual.h"

namespace armcal {

Eigen::MatrixXd Residual::encoders(const Eigen::MatrixXd& of_group) const {
  Eigen::MatrixXd own(of_group.rows(), count());
  for (Eigen::Index i = 0; i < count(); ++i) own.col(i) = of_group.col(row(i));
  return own;
}

Eigen::Matrix3Xd Residual::all_tips(const TipRows& tips, const PosturePacks& postures) {
  Eigen::Matrix3Xd result(3, postures.count());
  tips.fill(postures, 0, postures.count(), {.tips = result.data()});
  return result;
}

}  // namespace armcal
