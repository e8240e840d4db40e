// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "armcal/geometry/rigid_transform.h"

namespace armcal {

inline constexpr int kMinJoints = 2;
inline constexpr int kMaxJoints = 10;

/// Neighbouring axes nearer to parallel than this (10 deg) are described by beta instead of d and b
/// (Hayati).
inline constexpr double kNearlyParallel_rad = 0.17453292519943295;

/// One Fourier term of the error of an encoder: cos_rad * cos(k e) + sin_rad * sin(k e).
struct Harmonic {
  double cos_rad = 0.0;
  double sin_rad = 0.0;
};

/// What turns a reading e of an encoder into the angle theta that the joint really has:
///   theta = direction * (e + zero) + sum over k = 1.. of harmonics[k-1] at k e.
///   theory/kinematics.md eq. (2)
struct Joint {
  double zero_rad = 0.0;
  int direction = 1;  ///< +1 or -1
  /// Mechanical range of the encoder reading; infinite where there is no stop.
  double min_rad = -std::numeric_limits<double>::infinity();
  double max_rad = std::numeric_limits<double>::infinity();
  std::vector<Harmonic> harmonics;  ///< k = 1, 2, ..
};

/// Step from the frame of one joint to that of the next ("quasi-spherical" link, D-H with one more
/// offset):
///   RotZ(theta) TransZ(d) TransY(b) TransX(a) RotX(alpha) RotY(beta).   theory/kinematics.md eq.
///   (1)
/// beta (Hayati) stays 0 except between nearly parallel axes, where it takes the place of d as a
/// parameter.
struct Link {
  double d_mm = 0.0;
  double b_mm = 0.0;
  double a_mm = 0.0;
  double alpha_rad = 0.0;
  double beta_rad = 0.0;
};

/// The point that measures, in the frame of the last joint after its rotation; and, for robots, how
/// the flange is turned there (fixed-axis roll, pitch, yaw). A probe tip has no orientation: leave
/// it 0.
struct Tip {
  double a_mm = 0.0;
  double b_mm = 0.0;
  double d_mm = 0.0;
  Eigen::Vector3d roll_pitch_yaw_rad = Eigen::Vector3d::Zero();
};

/// Geometry of an arm of 2 to 10 revolute joints. Plain data: check it with `problems_of` when it
/// comes from outside.
struct ArmModel {
  std::string name;
  std::string note;           ///< where the numbers come from, for people
  std::vector<Joint> joints;  ///< n
  std::vector<Link> links;  ///< n - 1; links[i] leads from joint i+1 to joint i+2 (counted from 1)
  Tip tip;
  /// Where the frame of the first joint stands in the base frame in which tips are reported.
  RigidTransform base_from_first_joint;

  [[nodiscard]] int joint_count() const { return static_cast<int>(joints.size()); }
};

/// Do the axes at the ends of a link count as parallel?
[[nodiscard]] bool is_nearly_parallel(const Link& link);

/// RotX(alpha) RotY(beta): how the next axis is turned against the one before.
[[nodiscard]] Eigen::Matrix3d twist(const Link& link);

/// Everything that makes the model unusable, in words; empty when it is sound.
[[nodiscard]] std::vector<std::string> problems_of(const ArmModel& arm);

/// Longest conceivable distance of the tip from the first axis: sum of all offsets, mm.
[[nodiscard]] double reach_mm(const ArmModel& arm);

/// The arm with at least so many Fourier terms of every encoder, new ones 0.
[[nodiscard]] ArmModel with_harmonics(ArmModel arm, int harmonics);

}  // namespace armcal
