// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/clearance.h"
#include "armcal/core/diagnostics.h"
#include "armcal/core/progress.h"
#include "armcal/core/units.h"

namespace armcal {

/// Angles nearer than this need not be set anew.
inline constexpr double kSameAngle_rad = 1e-6;

/// A wish that no plan can fulfil; the message names the reason.
class ImpossiblePlan : public NumericalError {
 public:
  using NumericalError::NumericalError;
};

/// A half turn that could be read: one joint turns by half a turn, the others are locked.
struct HalfTurn {
  int joint = 0;  ///< that turns, from 1
  Eigen::VectorXd posture_rad;
  Eigen::VectorXd posture_end_rad;  ///< differs in `joint`, by +pi or -pi
};

/// A box in the base frame, mm.
struct MeasuringVolume {
  Eigen::Vector3d low_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d high_mm = Eigen::Vector3d::Zero();
};

/// Where half turns may be made.
struct HalfTurnRoom {
  /// Angles are multiples of this; 0: any angle.
  double grid_rad = radians_from_degrees(45.0);
  std::vector<int> joints;                ///< that may be turned, from 1; empty: all
  std::optional<MeasuringVolume> volume;  ///< of the reference machine; both tips lie inside
  Surroundings surroundings;              ///< what both postures keep clear of
};

/// What stood in the way of the postures that were tried.
struct Rejections {
  long tried = 0;
  long beyond_limit =
      0;  ///< no half turn within the limits of the joint, or no multiple of the grid
  long outside_volume = 0;
  long in_collision = 0;
  long no_distance = 0;  ///< the tip lies on the axis of the joint
  long repeated = 0;     ///< the same distance as one found before
};
[[nodiscard]] std::string explain(const Rejections& rejections);

/// Half turns drawn at random, no two of which are the same distance: the joint that turns and the
/// angles of those behind it make the distance, the others only carry both tips along.
/// Deterministic; fewer than `count` where the room has no more.
/// @param rejections  what stood in the way, added up
[[nodiscard]] std::vector<HalfTurn> half_turn_candidates(const ArmModel& arm,
                                                         const HalfTurnRoom& room, int count,
                                                         std::uint64_t seed, Rejections& rejections,
                                                         const Monitor& monitor = {});

/// Why the arm cannot stand at this end of a half turn: limit, volume, collision. Nothing where it
/// can.
[[nodiscard]] std::optional<std::string> obstacle(const ArmModel& arm, const HalfTurnRoom& room,
                                                  const Eigen::VectorXd& posture_rad);

}  // namespace armcal
