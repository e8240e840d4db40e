// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/residuals/frame_start.h"

#include <fmt/format.h>

#include "armcal/geometry/line.h"
#include "armcal/geometry/registration.h"
#include "armcal/identification/residuals/surface_rows.h"

namespace armcal {
namespace {

// Carries one line onto another; the turn about it is as good as any.
std::optional<RigidTransform> onto_line(const std::vector<Eigen::Vector3d>& source,
                                        const std::vector<Eigen::Vector3d>& target) {
  const LineFit from = fit_line(source);
  const LineFit onto = fit_line(target);
  if (!from.ok() || !onto.ok()) return std::nullopt;
  double same_sense = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    same_sense += (source[i] - from.point_mm).dot(from.direction) *
                  (target[i] - onto.point_mm).dot(onto.direction);
  }
  const Eigen::Vector3d direction =
      same_sense < 0.0 ? Eigen::Vector3d(-onto.direction) : onto.direction;
  RigidTransform result;
  result.rotation = rotation_between(from.direction, direction);
  result.translation_mm = onto.point_mm - result.rotation * from.point_mm;
  return result;
}

}  // namespace

std::optional<std::string> start_frame(const Eigen::Matrix3Xd& source_mm,
                                       const Eigen::Matrix3Xd& target_mm, int id,
                                       Unknowns& unknowns, Eigen::VectorXd& x, LineIsEnough line) {
  if (unknowns[id].started) return std::nullopt;
  const auto source = columns_of(source_mm);
  const auto target = columns_of(target_mm);
  const Registration fit = register_points(source, target);
  const auto by_line =
      line == LineIsEnough::yes && !fit.ok() ? onto_line(source, target) : std::nullopt;
  if (!fit.ok() && !by_line) {
    return fmt::format("the frame {} cannot be placed by its {} point{}: {}", unknowns[id].name,
                       source_mm.cols(), source_mm.cols() == 1 ? "" : "s", explain(fit.status));
  }
  unknowns.set_frame(x, id, by_line ? *by_line : fit.target_from_source);
  unknowns[id].pivot_mm = target_mm.rowwise().mean();
  unknowns[id].started = true;
  return std::nullopt;
}

}  // namespace armcal
