// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// Distance of the tip before and after turning one joint: r = |p(e) - p(e')| - l. Needs no frame.
/// theory/identification.md eq. (10)
class ReversalResidual : public Residual {
 public:
  ReversalResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
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
  PosturePacks before_, after_;
};

}  // namespace armcal
