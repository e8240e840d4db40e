// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// Tips on a sphere: r = |p(e) - c| - (R + t), c unknown, R known or unknown (`sphere.NAME`), t the
/// radius of the probe's ball (negative for contact from inside). theory/identification.md eq. (12)
class SphereResidual : public Residual {
 public:
  SphereResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
  [[nodiscard]] Eigen::Index rows_per_observation() const override { return 1; }
  [[nodiscard]] bool knows_scale() const override { return !radius_.has_value(); }
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
  std::optional<int> radius_;  // where it is unknown
};

}  // namespace armcal
