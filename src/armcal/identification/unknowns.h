// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/arm/tip_rows.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

/// What observations bring along that is unknown beside the arm.
enum class NuisanceKind {
  frame,   ///< a pose; step: small turn about the pivot (rad), shift (mm), both in its target frame
  point,   ///< x y z (mm)
  radius,  ///< mm
  plane,   ///< unit normal and distance from the origin; step: two tilts (rad), shift (mm)
  rotation,  ///< orientation of a target on the last joint; step: small turn (rad)
};

struct Nuisance {
  std::string name;  ///< setup.A, placement.A, point.A, sphere.A, plane.A, target.A
  NuisanceKind kind = NuisanceKind::point;
  Eigen::Vector3d pivot_mm =
      Eigen::Vector3d::Zero();  ///< frame: what a small turn leaves where it is
  bool started = false;         ///< has a start value
  Eigen::Index state = 0;       ///< place in the state vector
  Eigen::Index step = 0;        ///< place among the unknowns
};

/// Names of the components of a step, as in `setup.A.rx`.
[[nodiscard]] std::vector<std::string> step_names(const Nuisance& nuisance);

/// The unknowns of an identification: the free parameters of the arm, then what the observations
/// bring along. A state vector holds their values (rotations as matrices), a step moves it:
/// theory/identification.md eq. (1)-(4).
class Unknowns {
 public:
  /// @param free  indices into the parameter table of `arm`, which also gives all other values
  Unknowns(ArmModel arm, std::vector<int> free);

  /// The nuisance of this name and kind, made when it is new.
  int add(const std::string& name, NuisanceKind kind);
  [[nodiscard]] std::optional<int> find(const std::string& name, NuisanceKind kind) const;
  [[nodiscard]] Nuisance& operator[](int id) { return nuisances_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Nuisance& operator[](int id) const {
    return nuisances_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] const std::vector<Nuisance>& nuisances() const { return nuisances_; }

  /// The same unknowns with another choice of free arm parameters.
  [[nodiscard]] Unknowns with_free(std::vector<int> free) const;
  /// The state of `other`, whose nuisances are the same, with these free parameters.
  [[nodiscard]] Eigen::VectorXd state_from(const Unknowns& other, const Eigen::VectorXd& x) const;

  [[nodiscard]] const ArmModel& nominal() const { return arm_; }
  [[nodiscard]] const std::vector<int>& free() const { return free_; }
  [[nodiscard]] const std::vector<TipColumn>& columns() const { return columns_; }
  [[nodiscard]] int arm_size() const { return static_cast<int>(free_.size()); }
  [[nodiscard]] int step_size() const { return static_cast<int>(step_size_); }
  /// Names of all unknowns, in the order of a step.
  [[nodiscard]] std::vector<std::string> names() const;

  /// The nominal arm, and zeros for everything that has not been given a value yet.
  [[nodiscard]] Eigen::VectorXd start() const;
  [[nodiscard]] Eigen::VectorXd moved(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const;

  [[nodiscard]] ArmModel arm_at(const Eigen::VectorXd& x) const;
  [[nodiscard]] RigidTransform frame(const Eigen::VectorXd& x, int id) const;
  [[nodiscard]] Eigen::Vector3d point(const Eigen::VectorXd& x, int id) const;
  [[nodiscard]] double radius(const Eigen::VectorXd& x, int id) const;
  [[nodiscard]] Eigen::Vector4d plane(const Eigen::VectorXd& x, int id) const;
  [[nodiscard]] Eigen::Matrix3d rotation(const Eigen::VectorXd& x, int id) const;
  void set_frame(Eigen::VectorXd& x, int id, const RigidTransform& value) const;
  void set_point(Eigen::VectorXd& x, int id, const Eigen::Vector3d& value) const;
  void set_radius(Eigen::VectorXd& x, int id, double value) const;
  void set_plane(Eigen::VectorXd& x, int id, const Eigen::Vector4d& value) const;
  void set_rotation(Eigen::VectorXd& x, int id, const Eigen::Matrix3d& value) const;

 private:
  ArmModel arm_;
  Eigen::VectorXd nominal_values_;
  std::vector<std::string> parameter_names_;
  std::vector<int> free_;
  std::vector<TipColumn> columns_;
  std::vector<Nuisance> nuisances_;
  Eigen::Index state_size_ = 0;
  Eigen::Index step_size_ = 0;
};

}  // namespace armcal
