// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/observations/observation_group.h"

#include <array>
#include <utility>

namespace armcal {
namespace {

constexpr std::array<std::pair<ReferenceKind, std::string_view>, 9> kNames = {{
    {ReferenceKind::reference_points, "reference_points"},
    {ReferenceKind::reference_poses, "reference_poses"},
    {ReferenceKind::fixed_point, "fixed_point"},
    {ReferenceKind::artefact, "artefact"},
    {ReferenceKind::length, "length"},
    {ReferenceKind::reversal, "reversal"},
    {ReferenceKind::circle_radius, "circle_radius"},
    {ReferenceKind::sphere, "sphere"},
    {ReferenceKind::plane, "plane"},
}};

}  // namespace

std::string_view to_string(ReferenceKind kind) {
  for (const auto& [each, name] : kNames) {
    if (each == kind) return name;
  }
  return "unknown";
}

std::optional<ReferenceKind> reference_kind_named(std::string_view name) {
  for (const auto& [kind, each] : kNames) {
    if (each == name) return kind;
  }
  return std::nullopt;
}

std::vector<std::string> reference_kind_names() {
  std::vector<std::string> names;
  for (const auto& entry : kNames) names.emplace_back(entry.second);
  return names;
}

}  // namespace armcal
