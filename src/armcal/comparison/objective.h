// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/tip_rows.h"
#include "armcal/identification/residuals/residual.h"
#include "armcal/identification/unknowns.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// What a search without derivatives can see of readings: one number for each candidate arm, the
/// least sum of squared residuals over their uncertainties that frames, seats, spheres and planes
/// allow on that arm. At the optimum of `calibrate` it is its chi_squared.
/// theory/identification.md eq. (1), (18).
///
/// Fixed points, and lengths that share no point with each other, are placed in closed form, and
/// only the tips of the arm are computed (500 readings: some 10 us). Everything else is placed by
/// a small least-squares fit for each arm (500 reference points: some 200 us). Const and safe to
/// share between threads.
class ArmObjective {
 public:
  /// @param groups      must outlive the objective; rows that are held out do not count
  /// @param parameters  table indices of `nominal` that a candidate gives; the rest stays nominal
  /// @throws std::invalid_argument with the reason where the readings cannot be placed on the
  ///         nominal arm, or there are none
  ArmObjective(const ArmModel& nominal, std::span<const ObservationGroup> groups,
               std::vector<int> parameters);

  [[nodiscard]] const std::vector<int>& parameters() const { return parameters_; }
  /// Their values in the nominal arm.
  [[nodiscard]] Eigen::VectorXd start() const;
  /// @param values  mm or rad, one for each of `parameters()`
  [[nodiscard]] ArmModel arm(const Eigen::VectorXd& values) const;
  /// Infinite where the readings cannot be placed on that arm.
  [[nodiscard]] double operator()(const Eigen::VectorXd& values) const;

 private:
  struct Seat {
    std::string name;
    PosturePacks postures;
    Eigen::VectorXd weights;  // 1 / u^2
  };
  struct Distance {
    std::size_t from = 0, to = 0;
    double length_mm = 0.0, u_mm = 1.0;
  };
  void add_seats(std::span<const ObservationGroup> groups);
  void add_distances(const ObservationGroup& group);
  [[nodiscard]] double of_seats(const ArmModel& arm) const;
  [[nodiscard]] double of_others(const ArmModel& arm, std::string* problem) const;

  ArmModel nominal_;
  Eigen::VectorXd nominal_values_;
  std::vector<int> parameters_;
  std::vector<Seat> seats_;
  std::vector<Distance> distances_;
  Unknowns nuisances_;  // of the others, on no arm in particular
  std::vector<std::unique_ptr<Residual>> others_;
};

}  // namespace armcal
