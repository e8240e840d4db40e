// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "armcal/arm/arm_model.h"

namespace armcal::testing {

// Forward kinematics as the definition reads: a product of elementary 4x4 matrices, on any scalar.
// Slow and plain on purpose: an independent judge of the real one, and differentiable by complex
// steps.

template <typename Scalar>
using Matrix4 = Eigen::Matrix<Scalar, 4, 4>;

template <typename Scalar>
Matrix4<Scalar> elementary_rotation(int axis, const Scalar& angle) {
  using std::cos;
  using std::sin;
  Matrix4<Scalar> m = Matrix4<Scalar>::Identity();
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  m(i, i) = cos(angle);
  m(i, j) = -sin(angle);
  m(j, i) = sin(angle);
  m(j, j) = cos(angle);
  return m;
}

template <typename Scalar>
Matrix4<Scalar> elementary_shift(int axis, const Scalar& distance) {
  Matrix4<Scalar> m = Matrix4<Scalar>::Identity();
  m(axis, 3) = distance;
  return m;
}

/// Tip in base coordinates. @param values  parameters in table order; @param encoder  readings;
/// both of the arm `shape`, which gives directions, numbers of harmonics and the mount.
template <typename Scalar>
Eigen::Matrix<Scalar, 3, 1> elementary_tip(
    const ArmModel& shape, const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& values,
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& encoder) {
  const auto n = static_cast<Eigen::Index>(shape.joints.size());
  Matrix4<Scalar> pose = Matrix4<Scalar>::Identity();
  pose.template topLeftCorner<3, 3>() =
      shape.base_from_first_joint.rotation.template cast<Scalar>();
  pose.template topRightCorner<3, 1>() =
      shape.base_from_first_joint.translation_mm.template cast<Scalar>();
  Eigen::Index harmonic = n + 5 * (n - 1) + 3;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Joint& joint = shape.joints[static_cast<std::size_t>(i)];
    Scalar theta = static_cast<double>(joint.direction) * (encoder(i) + values(i));
    for (std::size_t k = 1; k <= joint.harmonics.size(); ++k, harmonic += 2) {
      const Scalar phase = static_cast<double>(k) * encoder(i);
      using std::cos;
      using std::sin;
      theta += values(harmonic) * cos(phase) + values(harmonic + 1) * sin(phase);
    }
    pose *= elementary_rotation(2, theta);
    const Eigen::Index at = n + 5 * i;
    if (i + 1 == n) {
      pose *= elementary_shift(0, values(at)) * elementary_shift(1, values(at + 1)) *
              elementary_shift(2, values(at + 2));
      break;
    }
    pose *= elementary_shift(2, values(at));
    pose *= elementary_shift(1, values(at + 1));
    pose *= elementary_shift(0, values(at + 2));
    pose *= elementary_rotation(0, values(at + 3));
    pose *= elementary_rotation(1, values(at + 4));
  }
  return pose.template topRightCorner<3, 1>();
}

}  // namespace armcal::testing
