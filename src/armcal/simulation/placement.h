// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armcal/simulation/laboratory.h"

namespace armcal {

/// A point that the tip is to be put on.
struct Feature {
  std::string name;  ///< "S3"
  Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
  /// Out of the surface that is touched there; zero where a seat holds the tip.
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();
};

/// Something that is put down in the laboratory, in its own frame.
struct Solid {
  std::string name;  ///< for messages: "plate-2"
  std::vector<Feature> features;
  /// What else takes up room: points of its body, closer together than a column is thick.
  std::vector<Eigen::Vector3d> body_mm;
};

/// Points of a straight bar, or of a rectangular plate about the origin, as a body.
[[nodiscard]] std::vector<Eigen::Vector3d> bar_body(const Eigen::Vector3d& from_mm,
                                                    const Eigen::Vector3d& to_mm);
[[nodiscard]] std::vector<Eigen::Vector3d> plate_body(double size_x_mm, double size_y_mm);

/// Puts a solid down where the arm reaches every feature in more ways than one, the whole of it
/// above the bench and outside the column: the first of some hundred places at random that does.
/// @throws Impossible naming the solid and what of it is where it cannot be
[[nodiscard]] RigidTransform place_within_reach(Laboratory& laboratory, const Solid& solid);

/// A feature as it stands in the base frame.
[[nodiscard]] Feature placed(const RigidTransform& base_from_solid, const Feature& feature);

/// What keeps a point of the base frame from being part of an artefact: "12.3 mm below the bench";
/// nothing where it is free.
[[nodiscard]] std::optional<std::string> obstruction(const VirtualArm& arm,
                                                     const Eigen::Vector3d& point_mm);

}  // namespace armcal
