// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace armcal {

/// A rotation and a translation (mm) that carry coordinates of a source frame into a target frame.
///
/// Name objects `target_from_source`: then `base_from_tip = base_from_wrist * wrist_from_tip` reads
/// itself, inner names cancel, and `tip_in_base = base_from_tip * point_in_tip`.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation_mm = Eigen::Vector3d::Zero();

  [[nodiscard]] RigidTransform inverse() const {
    const Eigen::Matrix3d transposed = rotation.transpose();
    return {transposed, -(transposed * translation_mm)};
  }
};

[[nodiscard]] inline RigidTransform operator*(const RigidTransform& target_from_middle,
                                              const RigidTransform& middle_from_source) {
  return {target_from_middle.rotation * middle_from_source.rotation,
          target_from_middle.rotation * middle_from_source.translation_mm +
              target_from_middle.translation_mm};
}

[[nodiscard]] inline Eigen::Vector3d operator*(const RigidTransform& target_from_source,
                                               const Eigen::Vector3d& point_in_source) {
  return target_from_source.rotation * point_in_source + target_from_source.translation_mm;
}

/// Matrix of the cross product: skew(a) * b = a x b.
[[nodiscard]] Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// Rotation about the direction of `rotation_vector_rad` by its length: the exponential map,
/// Rodrigues' formula, by series for small angles so that nothing is lost at 1e-12 rad.
/// theory/kinematics.md eq. (9).
[[nodiscard]] Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& rotation_vector_rad);

/// The inverse: a vector of length at most pi. Accurate to rounding also at angles near 0 and near
/// pi.
[[nodiscard]] Eigen::Vector3d vector_from_rotation(const Eigen::Matrix3d& rotation);

/// Rotation about the z axis; exactly the identity at 0.
[[nodiscard]] Eigen::Matrix3d rotation_about_z(double angle_rad);

/// The least rotation that turns one unit vector onto another; between opposite ones, half a turn
/// about some axis across.
[[nodiscard]] Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from,
                                               const Eigen::Vector3d& onto);

/// Rz(yaw) * Ry(pitch) * Rx(roll): fixed-axis angles about x, then y, then z, as in URDF.
[[nodiscard]] Eigen::Matrix3d rotation_from_roll_pitch_yaw(
    const Eigen::Vector3d& roll_pitch_yaw_rad);

/// The inverse; pitch within +-pi/2, and roll 0 where only the sum of roll and yaw is defined.
[[nodiscard]] Eigen::Vector3d roll_pitch_yaw_from_rotation(const Eigen::Matrix3d& rotation);

/// Two unit vectors that complete the unit vector `axis` to a right-handed triad (first, second,
/// axis).
struct PerpendicularPair {
  Eigen::Vector3d first;
  Eigen::Vector3d second;
};
[[nodiscard]] PerpendicularPair perpendicular_pair(const Eigen::Vector3d& axis);

/// `direction` or its opposite: that whose component of largest magnitude is positive. A direction
/// without a sense (of a line, of the normal of a plane) gets one that does not depend on chance.
[[nodiscard]] Eigen::Vector3d with_largest_component_positive(const Eigen::Vector3d& direction);

}  // namespace armcal
