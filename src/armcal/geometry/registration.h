// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>

#include "armcal/geometry/fit_summary.h"
#include "armcal/geometry/rigid_transform.h"

namespace armcal {

struct Registration : FitSummary {
  /// target = scale * rotation * source + translation
  RigidTransform target_from_source;
  double scale = 1.0;
  Eigen::Matrix3Xd residual_vectors_mm;  ///< target - transformed source, per point
  /// A reflection, which is never returned, would leave less than a tenth of the residuals.
  bool looks_mirrored = false;
};

struct RegistrationOptions : FitOptions {
  bool estimate_scale = false;
};

/// Least-squares rigid transform between paired points, on demand with a common scale.
///
/// Method: theory/registration.md (Kabsch 1976 and Umeyama, IEEE PAMI 13 (1991) 376-380, by
/// singular values). A reflection is never returned, also where it would fit better. residuals_mm
/// are lengths; form_mm is the largest of them. covariance_of: rotation_x rotation_y rotation_z
/// (small rotation vector r in the target frame, rad: the true rotation is exp(r) times the fitted
/// one), x y z of the translation as it is given (mm), and scale where it was estimated. Status
/// `points_are_collinear` / `points_coincide` where the points leave a rotation free, `ambiguous`
/// where the pairs are so far from a rotation (mirrored, say) that two rotations fit alike.
/// @param source, target  same number of points (else std::invalid_argument), at least 3, mm
[[nodiscard]] Registration register_points(std::span<const Eigen::Vector3d> source,
                                           std::span<const Eigen::Vector3d> target,
                                           const RegistrationOptions& options = {});

/// The rotation that is nearest to a matrix (least squares of the entries).
[[nodiscard]] Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

}  // namespace armcal
