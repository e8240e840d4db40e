// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// Points measured by a reference machine, in its frame: r = R^T (T p(e) - q), T = (R, t) the
/// unknown pose of the arm's base in that frame (`setup.NAME`). Turning the difference back into
/// the base frame changes no length, and leaves the arm's columns as they are; derivatives are
/// those of T p - q, turned alike, so that normal equations are the same as without the turn.
/// theory/identification.md eq. (5)
class ReferencePointsResidual : public Residual {
 public:
  ReferencePointsResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
  std::optional<std::string> start(const ArmAt& nominal, Unknowns& unknowns,
                                   Eigen::VectorXd& x) const override;
  void fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x, Eigen::Index first,
            Eigen::Index count, const BlockRows& rows) const override;
  [[nodiscard]] ObservedPlaces places(const ArmAt& at, const Unknowns& unknowns,
                                      const Eigen::VectorXd& x) const override;
  [[nodiscard]] Eigen::MatrixXd J_residual_encoders(const ArmModel& arm, const Unknowns& unknowns,
                                                    const Eigen::VectorXd& x) const override;

 private:
  MeasuredPoint point_;
  Eigen::Matrix3Xd reference_mm_;
  int setup_;
};

}  // namespace armcal
