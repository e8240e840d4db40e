// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/arm/estimability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "armcal/core/units.h"

namespace armcal {
namespace {

// 0 is wanted most.
int rank_of_wish(const ArmModel& arm, const Parameter& parameter) {
  using Kind = ParameterKind;
  const int n = arm.joint_count();
  const bool is_link = parameter.kind == Kind::d || parameter.kind == Kind::b ||
                       parameter.kind == Kind::a || parameter.kind == Kind::alpha ||
                       parameter.kind == Kind::beta;
  const bool parallel =
      is_link && is_nearly_parallel(arm.links[static_cast<std::size_t>(parameter.joint - 2)]);
  switch (parameter.kind) {
    case Kind::zero:
      if (parameter.joint == 1) return 9;
      return parameter.joint == n ? 7 : 1;
    case Kind::d:
      return parameter.joint == 2 ? 8 : (parallel ? 5 : 3);
    case Kind::b:
      return parallel ? 4 : 0;
    case Kind::beta:
      return parallel ? 0 : 6;
    case Kind::cosine:
    case Kind::sine:
      return 2;
    default:
      return 0;
  }
}

}  // namespace

std::vector<int> wanted_order(const ArmModel& arm, const ParameterTable& table) {
  std::vector<int> order(static_cast<std::size_t>(table.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int one, int other) {
    return rank_of_wish(arm, table[one]) < rank_of_wish(arm, table[other]);
  });
  return order;
}

std::optional<std::string> held_by_convention(const ArmModel& arm, const Parameter& parameter) {
  if (parameter.kind == ParameterKind::zero && parameter.joint == 1) {
    return "by convention: it only turns the base frame";
  }
  if (parameter.kind == ParameterKind::d && parameter.joint == 2) {
    return "by convention: it only shifts the base frame";
  }
  const auto link = [&]() -> const Link& {
    return arm.links[static_cast<std::size_t>(parameter.joint - 2)];
  };
  // A link along x that turns between two parallel axes, the second turned back, moves by b alone.
  if (parameter.kind == ParameterKind::b && parameter.joint == 2 && is_nearly_parallel(link()) &&
      std::abs(link().a_mm) > std::abs(link().b_mm)) {
    return "by convention: with zero2 it only turns the base frame";
  }
  if (parameter.kind == ParameterKind::beta && !is_nearly_parallel(link()))
    return "by convention: beta is for nearly parallel axes";
  return std::nullopt;
}

std::string describe(const DependentColumn& dependent, const RankAnalysis& analysis,
                     const std::vector<std::string>& names) {
  // Weights in the same units compare; what is below a thousandth of the largest is left out.
  std::vector<std::pair<double, std::string>> parts;
  double largest = 0.0;
  for (const double weight : dependent.weights) largest = std::max(largest, std::abs(weight));
  for (std::size_t i = 0; i < analysis.basis.size(); ++i) {
    const double weight = dependent.weights(static_cast<Eigen::Index>(i));
    if (std::abs(weight) > 1e-3 * largest) {
      parts.emplace_back(std::abs(weight), names[static_cast<std::size_t>(analysis.basis[i])]);
    }
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  constexpr std::size_t kNamed = 4;
  std::string text;
  for (std::size_t i = 0; i < parts.size() && i < kNamed; ++i) {
    if (i > 0)
      text += i + 1 == std::min(parts.size(), kNamed) && parts.size() <= kNamed ? " and " : ", ";
    text += parts[i].second;
  }
  if (parts.size() > kNamed) text += fmt::format(" and {} more", parts.size() - kNamed);
  return fmt::format("{} moves every reading like {}{}",
                     names[static_cast<std::size_t>(dependent.column)], text,
                     parts.size() > 1 ? " together" : "");
}

}  // namespace armcal
