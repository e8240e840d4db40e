// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/identification/residuals/measured_point.h"

namespace armcal {

/// Points of an artefact with calibrated coordinates g (sphere plate, ball bar, multi-sphere gauge)
/// in one placement: r = p(e) - P g, P the unknown pose of the artefact in the base frame
/// (`placement.NAME`). theory/identification.md eq. (8)
class ArtefactResidual : public Residual {
 public:
  ArtefactResidual(const ObservationGroup& group, std::vector<int> rows, Unknowns& unknowns);
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
  Eigen::Matrix3Xd calibrated_mm_;
  int placement_;
};

}  // namespace armcal
