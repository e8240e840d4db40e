// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/parameter_table.h"

namespace armcal {

/// Postures that are computed side by side.
inline constexpr Eigen::Index kLanes = 8;

/// Postures of an arm, ready for TipRows: sine and cosine of every encoder reading, eight postures
/// side by side (the last pack is filled up with its last posture). Readings do not change while an
/// arm is identified, so their sines are taken once.
class PosturePacks {
 public:
  PosturePacks() = default;
  /// @param encoder_rad  one posture per column, rows the joints
  explicit PosturePacks(const Eigen::MatrixXd& encoder_rad);

  [[nodiscard]] int joint_count() const { return joint_count_; }
  [[nodiscard]] Eigen::Index count() const { return count_; }
  /// kLanes sines, then as many cosines, of one joint in one pack.
  [[nodiscard]] const double* at(Eigen::Index pack, int joint) const {
    return values_.data() + 2 * kLanes * (pack * joint_count_ + joint);
  }

 private:
  int joint_count_ = 0;
  Eigen::Index count_ = 0;
  std::vector<double> values_;
};

/// One derivative column of TipRows.
struct TipColumn {
  ParameterKind kind = ParameterKind::zero;
  int joint =
      0;  ///< from 0: of a zero or harmonic, the first joint of a link, the last one for the tip
  int harmonic = 0;
};

/// @param parameters  table indices
[[nodiscard]] std::vector<TipColumn> tip_columns(const ParameterTable& table,
                                                 std::span<const int> parameters);

/// Tips of many postures and their derivatives by chosen parameters, as rows of a least-squares
/// problem: what ForwardKinematics::linearise gives one posture at a time, eight at a time.
/// theory/kinematics.md eq. (1)-(8); the angle is turned through the cached sine and cosine: sin(s
/// (e + z) + h) by the addition theorem. Const and safe to share between threads.
class TipRows {
 public:
  /// @throws std::invalid_argument for a model that is not sound
  TipRows(const ArmModel& arm, std::span<const TipColumn> columns);

  /// Where the results of posture first + k go: the tip (mm, base frame) to tips.col(k), the
  /// derivative of its coordinate c by parameter i to rows[(3 k + c) * stride + i]. `rows` may be
  /// null.
  struct Target {
    double* tips = nullptr;
    double* rows = nullptr;
    Eigen::Index stride = 0;
    Eigen::Index rows_per_posture =
        3;  ///< more where other rows stand between: rows[(rows_per_posture * k + c) * stride + i]
  };
  /// @param first  a multiple of kLanes
  void fill(const PosturePacks& postures, Eigen::Index first, Eigen::Index count,
            const Target& target) const;

  [[nodiscard]] int column_count() const { return static_cast<int>(columns_.size()); }

 private:
  struct PreparedJoint {
    double direction, sin_zero, cos_zero;  // of direction * zero
    std::vector<Harmonic> harmonics;
  };
  struct PreparedLink {
    double d, b, a, cos_alpha, sin_alpha, cos_beta, sin_beta;
  };
  template <class Pack>
  friend class TipKernel;

  RigidTransform base_;
  std::vector<PreparedJoint> joints_;
  std::vector<PreparedLink> links_;
  Tip tip_;
  std::vector<TipColumn> columns_;
};

}  // namespace armcal
