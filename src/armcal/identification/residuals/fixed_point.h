// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// The tip in one cone, seat or socket, in many postures: r = p(e) - c, c unknown (`point.NAME`).
/// theory/identification.md eq. (7)
class FixedPointResidual : public Residual {
 public:
  FixedPointResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
  [[nodiscard]] bool knows_scale() const override { return false; }
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
  int center_;
};

}  // namespace armcal
