// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/core/diagnostics.h"

namespace armcal {

/// What an arm can be held against. docs/files/session.md, theory/identification.md.
enum class ReferenceKind {
  reference_points,  ///< tips measured by a reference machine, in its own frame
  reference_poses,   ///< position and orientation of a target on the arm, measured by a tracker
  fixed_point,       ///< the tip in one cone or seat, in many postures; place unknown
  artefact,          ///< points with calibrated coordinates; placement unknown
  length,            ///< a calibrated distance between two fixed points
  reversal,          ///< distance of the tip before and after turning one joint
  circle_radius,     ///< distance of the tip from the axis of a joint
  sphere,            ///< tips on a sphere, radius known or not
  plane,             ///< tips on a plane
};

[[nodiscard]] std::string_view to_string(ReferenceKind kind);
/// @return nothing where no kind is called so
[[nodiscard]] std::optional<ReferenceKind> reference_kind_named(std::string_view name);
[[nodiscard]] std::vector<std::string> reference_kind_names();

/// Readings of one kind that belong together, row by row. Plain data; which members are filled
/// depends on the kind.
struct ObservationGroup {
  std::string name;
  ReferenceKind kind = ReferenceKind::reference_points;
  SourcePosition where;  ///< of the group, in the session
  std::string file;      ///< of its rows
  std::vector<int> lines;
  std::vector<bool> is_check;       ///< rows that are held out of the fit
  Eigen::VectorXd u_mm;             ///< standard uncertainty of a coordinate, distance or radius
  double u_encoder_rad = 0.0;       ///< standard uncertainty of each encoder reading
  Eigen::MatrixXd encoder_rad;      ///< joints x rows; empty for lengths
  Eigen::MatrixXd encoder_end_rad;  ///< reversal: after the turn
  Eigen::Matrix3Xd
      reference_mm;  ///< measured points; artefact: calibrated coordinates of the feature
  std::vector<Eigen::Matrix3d> orientation;  ///< reference_poses: reference_from_target
  double lever_mm = 100.0;   ///< reference_poses: how far apart the three points of the target are
  Eigen::VectorXd value_mm;  ///< length, reversal, circle_radius
  /// Name of what is unknown beside the arm: set-up, placement, fixed point (of a length: the
  /// first), sphere, plane.
  std::vector<std::string> place;
  std::vector<std::string> place_to;  ///< length: the second fixed point
  std::vector<std::string> feature;   ///< artefact: which of its points
  std::vector<int> joint;           ///< circle_radius, reversal, points on arcs: that turns, from 1
  std::optional<double> radius_mm;  ///< sphere: where it is known
  double tip_radius_mm = 0.0;       ///< sphere: added to the radius (outside contact)
  Eigen::Vector3d offset_mm =
      Eigen::Vector3d::Zero();  ///< of the measured point from the tip, in the tip's frame
  std::string target;  ///< not empty: the measured point is this unknown point of the last joint,
                       ///< not the tip

  /// When each row was read, s: since 1970-01-01T00:00:00Z where `time_is_utc`, else since a start
  /// that nobody knows. NaN where a row does not say; empty where none does.
  Eigen::VectorXd time_s;
  bool time_is_utc = false;
  Eigen::VectorXd temperature_c;  ///< at each row; NaN and empty alike

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(lines.size()); }
};

}  // namespace armcal
