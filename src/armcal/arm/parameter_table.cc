// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/parameter_table.h"

#include <fmt/format.h>

#include "armcal/core/invariant.h"
#include "armcal/core/spelling.h"

namespace armcal {
namespace {

// Visits a reference to every parameter in table order; `Arm` is ArmModel or const ArmModel.
template <typename Arm, typename Visit>
void for_each_parameter(Arm& arm, const Visit& visit) {
  using Kind = ParameterKind;
  int joint = 1;
  for (auto& j : arm.joints) visit(Kind::zero, joint++, 0, j.zero_rad);
  joint = 2;
  for (auto& link : arm.links) {
    visit(Kind::d, joint, 0, link.d_mm);
    visit(Kind::b, joint, 0, link.b_mm);
    visit(Kind::a, joint, 0, link.a_mm);
    visit(Kind::alpha, joint, 0, link.alpha_rad);
    visit(Kind::beta, joint, 0, link.beta_rad);
    ++joint;
  }
  visit(Kind::tip_a, joint, 0, arm.tip.a_mm);
  visit(Kind::tip_b, joint, 0, arm.tip.b_mm);
  visit(Kind::tip_d, joint, 0, arm.tip.d_mm);
  joint = 1;
  for (auto& j : arm.joints) {
    int order = 1;
    for (auto& harmonic : j.harmonics) {
      visit(Kind::cosine, joint, order, harmonic.cos_rad);
      visit(Kind::sine, joint, order, harmonic.sin_rad);
      ++order;
    }
    ++joint;
  }
}

std::string name_of(ParameterKind kind, int joint, int harmonic) {
  switch (kind) {
    case ParameterKind::zero:
      return fmt::format("zero{}", joint);
    case ParameterKind::d:
    case ParameterKind::tip_d:
      return fmt::format("d{}", joint);
    case ParameterKind::b:
    case ParameterKind::tip_b:
      return fmt::format("b{}", joint);
    case ParameterKind::a:
    case ParameterKind::tip_a:
      return fmt::format("a{}", joint);
    case ParameterKind::alpha:
      return fmt::format("alpha{}", joint);
    case ParameterKind::beta:
      return fmt::format("beta{}", joint);
    case ParameterKind::cosine:
      return fmt::format("cos{}_{}", harmonic, joint);
    case ParameterKind::sine:
      return fmt::format("sin{}_{}", harmonic, joint);
  }
  return {};
}

ParameterUnit unit_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::d:
    case ParameterKind::b:
    case ParameterKind::a:
    case ParameterKind::tip_a:
    case ParameterKind::tip_b:
    case ParameterKind::tip_d:
      return ParameterUnit::mm;
    default:
      return ParameterUnit::rad;
  }
}

}  // namespace

std::string_view to_string(ParameterUnit unit) { return unit == ParameterUnit::mm ? "mm" : "rad"; }

std::string_view to_string(ParameterStatus status) {
  switch (status) {
    case ParameterStatus::free:
      return "free";
    case ParameterStatus::held:
      return "held";
    case ParameterStatus::prior:
      return "prior";
  }
  return "unknown";
}

ParameterTable::ParameterTable(const ArmModel& arm) {
  for_each_parameter(arm, [&](ParameterKind kind, int joint, int harmonic, const double& value) {
    parameters_.push_back({name_of(kind, joint, harmonic), kind, joint, harmonic, unit_of(kind),
                           value, ParameterStatus::held});
  });
}

std::vector<std::string> ParameterTable::names() const {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters_) names.push_back(parameter.name);
  return names;
}

Eigen::VectorXd ParameterTable::nominal() const {
  Eigen::VectorXd values(size());
  for (int i = 0; i < size(); ++i) values(i) = (*this)[i].nominal;
  return values;
}

std::optional<int> ParameterTable::find(std::string_view name) const {
  for (int i = 0; i < size(); ++i) {
    if ((*this)[i].name == name) return i;
  }
  return std::nullopt;
}

std::vector<int> ParameterTable::matching(std::string_view pattern) const {
  std::vector<int> indices;
  for (int i = 0; i < size(); ++i) {
    if (matches_glob((*this)[i].name, pattern)) indices.push_back(i);
  }
  return indices;
}

Eigen::VectorXd parameter_values(const ArmModel& arm) { return ParameterTable(arm).nominal(); }

ArmModel with_parameter_values(const ArmModel& arm, const Eigen::VectorXd& values) {
  ArmModel result = arm;
  Eigen::Index next = 0;
  for_each_parameter(result, [&](ParameterKind, int, int, double& value) {
    ARMCAL_INVARIANT(next < values.size());
    value = values(next++);
  });
  ARMCAL_INVARIANT(next == values.size());
  return result;
}

}  // namespace armcal
