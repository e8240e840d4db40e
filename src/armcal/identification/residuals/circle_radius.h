// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/residual.h"

namespace armcal {

/// Radius of the circle that the tip makes about one joint: r = |(p - o) - z (z . (p - o))| - rho,
/// o and z point and direction of the joint's axis. theory/identification.md eq. (11)
class CircleRadiusResidual : public Residual {
 public:
  CircleRadiusResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
  [[nodiscard]] Eigen::Index rows_per_observation() const override { return 1; }
  std::optional<std::string> start(const ArmAt& nominal, Unknowns& unknowns,
                                   Eigen::VectorXd& x) const override;
  void fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x, Eigen::Index first,
            Eigen::Index count, const BlockRows& rows) const override;
  [[nodiscard]] ObservedPlaces places(const ArmAt& at, const Unknowns& unknowns,
                                      const Eigen::VectorXd& x) const override;
  [[nodiscard]] Eigen::MatrixXd J_residual_encoders(const ArmModel& arm, const Unknowns& unknowns,
                                                    const Eigen::VectorXd& x) const override;

 private:
  Eigen::MatrixXd encoder_rad_;
};

}  // namespace armcal
