// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/unknowns.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "armcal/core/invariant.h"

namespace armcal {
namespace {

Eigen::Index state_size(NuisanceKind kind) {
  switch (kind) {
    case NuisanceKind::frame:
      return 12;
    case NuisanceKind::point:
      return 3;
    case NuisanceKind::radius:
      return 1;
    case NuisanceKind::plane:
      return 4;
    case NuisanceKind::rotation:
      return 9;
  }
  return 0;
}

// Rounding makes a product of many small turns drift from a rotation.
Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& nearly) {
  return Eigen::Quaterniond(nearly).normalized().toRotationMatrix();
}

}  // namespace

std::vector<std::string> step_names(const Nuisance& nuisance) {
  std::vector<const char*> parts;
  switch (nuisance.kind) {
    case NuisanceKind::frame:
      parts = {"rx", "ry", "rz", "x", "y", "z"};
      break;
    case NuisanceKind::point:
      parts = {"x", "y", "z"};
      break;
    case NuisanceKind::radius:
      parts = {"radius"};
      break;
    case NuisanceKind::plane:
      parts = {"tilt1", "tilt2", "distance"};
      break;
    case NuisanceKind::rotation:
      parts = {"rx", "ry", "rz"};
      break;
  }
  std::vector<std::string> names;
  for (const char* part : parts) names.push_back(nuisance.name + "." + part);
  return names;
}

Unknowns::Unknowns(ArmModel arm, std::vector<int> free)
    : arm_(std::move(arm)), free_(std::move(free)) {
  const ParameterTable table(arm_);
  nominal_values_ = table.nominal();
  for (const int index : free_) parameter_names_.push_back(table[index].name);
  columns_ = tip_columns(table, free_);
  state_size_ = step_size_ = arm_size();
}

int Unknowns::add(const std::string& name, NuisanceKind kind) {
  if (const auto known = find(name, kind)) return *known;
  Nuisance nuisance;
  nuisance.name = name;
  nuisance.kind = kind;
  nuisance.state = state_size_;
  nuisance.step = step_size_;
  state_size_ += state_size(kind);
  step_size_ += static_cast<Eigen::Index>(step_names(nuisance).size());
  nuisances_.push_back(std::move(nuisance));
  return static_cast<int>(nuisances_.size()) - 1;
}

std::optional<int> Unknowns::find(const std::string& name, NuisanceKind kind) const {
  const auto at = std::find_if(nuisances_.begin(), nuisances_.end(), [&](const Nuisance& each) {
    return each.name == name && each.kind == kind;
  });
  if (at == nuisances_.end()) return std::nullopt;
  return static_cast<int>(at - nuisances_.begin());
}

Unknowns Unknowns::with_free(std::vector<int> free) const {
  Unknowns result(arm_, std::move(free));
  for (const Nuisance& nuisance : nuisances_) {
    const int id = result.add(nuisance.name, nuisance.kind);
    result[id].pivot_mm = nuisance.pivot_mm;
    result[id].started = nuisance.started;
  }
  return result;
}

Eigen::VectorXd Unknowns::state_from(const Unknowns& other, const Eigen::VectorXd& x) const {
  Eigen::VectorXd result(state_size_);
  const Eigen::VectorXd values = parameter_values(other.arm_at(x));
  for (int i = 0; i < arm_size(); ++i) result(i) = values(free_[static_cast<std::size_t>(i)]);
  result.tail(state_size_ - arm_size()) = x.tail(x.size() - other.arm_size());
  return result;
}

std::vector<std::string> Unknowns::names() const {
  std::vector<std::string> names = parameter_names_;
  for (const Nuisance& nuisance : nuisances_) {
    for (std::string& name : step_names(nuisance)) names.push_back(std::move(name));
  }
  return names;
}

Eigen::VectorXd Unknowns::start() const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(state_size_);
  for (int i = 0; i < arm_size(); ++i) x(i) = nominal_values_(free_[static_cast<std::size_t>(i)]);
  for (int id = 0; id < static_cast<int>(nuisances_.size()); ++id) {
    const NuisanceKind kind = (*this)[id].kind;
    if (kind == NuisanceKind::frame) set_frame(x, id, {});
    if (kind == NuisanceKind::rotation) set_rotation(x, id, Eigen::Matrix3d::Identity());
    if (kind == NuisanceKind::plane) set_plane(x, id, {0, 0, 1, 0});
  }
  return x;
}

Eigen::VectorXd Unknowns::moved(const Eigen::VectorXd& x, const Eigen::VectorXd& step) const {
  Eigen::VectorXd result = x;
  result.head(arm_size()) += step.head(arm_size());
  for (int id = 0; id < static_cast<int>(nuisances_.size()); ++id) {
    const Nuisance& nuisance = (*this)[id];
    const auto at = step.segment(nuisance.step, 3 * (nuisance.kind != NuisanceKind::radius));
    switch (nuisance.kind) {
      case NuisanceKind::frame: {
        RigidTransform pose = frame(x, id);
        const Eigen::Matrix3d turn = rotation_from_vector(at);
        pose.translation_mm = turn * (pose.translation_mm - nuisance.pivot_mm) + nuisance.pivot_mm +
                              step.segment<3>(nuisance.step + 3);
        pose.rotation = orthonormal(turn * pose.rotation);
        set_frame(result, id, pose);
        break;
      }
      case NuisanceKind::point:
        set_point(result, id, point(x, id) + at);
        break;
      case NuisanceKind::radius:
        result(nuisance.state) += step(nuisance.step);
        break;
      case NuisanceKind::plane: {
        Eigen::Vector4d value = plane(x, id);
        const auto [first, second] = perpendicular_pair(value.head<3>());
        // The plane tilts about its pivot.
        const double height = value.head<3>().dot(nuisance.pivot_mm) - value(3);
        value.head<3>() = (value.head<3>() + at(0) * first + at(1) * second).normalized();
        value(3) = value.head<3>().dot(nuisance.pivot_mm) - height + at(2);
        set_plane(result, id, value);
        break;
      }
      case NuisanceKind::rotation:
        set_rotation(result, id, orthonormal(rotation_from_vector(at) * rotation(x, id)));
        break;
    }
  }
  return result;
}

ArmModel Unknowns::arm_at(const Eigen::VectorXd& x) const {
  Eigen::VectorXd values = nominal_values_;
  for (int i = 0; i < arm_size(); ++i) values(free_[static_cast<std::size_t>(i)]) = x(i);
  return with_parameter_values(arm_, values);
}

RigidTransform Unknowns::frame(const Eigen::VectorXd& x, int id) const {
  const Eigen::Index at = (*this)[id].state;
  return {x.segment<9>(at).reshaped<Eigen::AutoOrder>(3, 3), x.segment<3>(at + 9)};
}
Eigen::Vector3d Unknowns::point(const Eigen::VectorXd& x, int id) const {
  return x.segment<3>((*this)[id].state);
}
double Unknowns::radius(const Eigen::VectorXd& x, int id) const { return x((*this)[id].state); }
Eigen::Vector4d Unknowns::plane(const Eigen::VectorXd& x, int id) const {
  return x.segment<4>((*this)[id].state);
}
Eigen::Matrix3d Unknowns::rotation(const Eigen::VectorXd& x, int id) const {
  return x.segment<9>((*this)[id].state).reshaped<Eigen::AutoOrder>(3, 3);
}

void Unknowns::set_frame(Eigen::VectorXd& x, int id, const RigidTransform& value) const {
  const Eigen::Index at = (*this)[id].state;
  x.segment<9>(at) = value.rotation.reshaped();
  x.segment<3>(at + 9) = value.translation_mm;
}
void Unknowns::set_point(Eigen::VectorXd& x, int id, const Eigen::Vector3d& value) const {
  x.segment<3>((*this)[id].state) = value;
}
void Unknowns::set_radius(Eigen::VectorXd& x, int id, double value) const {
  x((*this)[id].state) = value;
}
void Unknowns::set_plane(Eigen::VectorXd& x, int id, const Eigen::Vector4d& value) const {
  x.segment<4>((*this)[id].state) = value;
}
void Unknowns::set_rotation(Eigen::VectorXd& x, int id, const Eigen::Matrix3d& value) const {
  x.segment<9>((*this)[id].state) = value.reshaped();
}

}  // namespace armcal
