// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/residual.h"

namespace armcal {

/// Position and orientation of a target on the arm, as trackers give them: counts as three points
/// of the target, its origin and one `lever_mm` along its x and its y, each a reference point. How
/// the target is turned on the last joint is unknown (`target.NAME.rx ry rz`; NAME is the group's
/// where no target is named). theory/identification.md eq. (6)
class ReferencePosesResidual : public Residual {
 public:
  ReferencePosesResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
  [[nodiscard]] Eigen::Index rows_per_observation() const override { return 9; }
  std::optional<std::string> start(const ArmAt& nominal, Unknowns& unknowns,
                                   Eigen::VectorXd& x) const override;
  void fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x, Eigen::Index first,
            Eigen::Index count, const BlockRows& rows) const override;
  [[nodiscard]] ObservedPlaces places(const ArmAt& at, const Unknowns& unknowns,
                                      const Eigen::VectorXd& x) const override;
  [[nodiscard]] Eigen::MatrixXd J_residual_encoders(const ArmModel& arm, const Unknowns& unknowns,
                                                    const Eigen::VectorXd& x) const override;

 private:
  [[nodiscard]] Eigen::Vector3d origin(const ArmModel& arm, const Unknowns& unknowns,
                                       const Eigen::VectorXd& x) const;

  PosturePacks postures_;
  std::optional<int> target_;
  int rotation_;
  int setup_;
};

}  // namespace armcal
