// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// Tips on a plane: r = n . p(e) - h, n and h unknown (`plane.NAME`). theory/identification.md eq.
/// (13)
class PlaneResidual : public Residual {
 public:
  PlaneResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
  [[nodiscard]] Eigen::Index rows_per_observation() const override { return 1; }
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
  int plane_;
};

}  // namespace armcal
