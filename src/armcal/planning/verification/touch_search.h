// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/clearance.h"
#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/inverse_kinematics.h"
#include "armcal/core/random.h"
#include "armcal/planning/half_turn_candidates.h"

namespace armcal {

/// Where an arm is verified.
struct VerificationRoom {
  Surroundings surroundings;              ///< what every posture and artefact keeps clear of
  std::optional<MeasuringVolume> volume;  ///< of the base frame; every point lies inside
};

/// A point that the tip is put on.
struct Touch {
  Eigen::Vector3d tip_mm;  ///< centre of the tip's ball, in the base frame
  /// Out of what is touched. The stylus stands on this side: from the tip back to the origin of the
  /// last joint it leads outward, so it never enters a ball of which this is the normal.
  Eigen::Vector3d outward;
};

/// Finds postures of an arm for points, within the limits of its joints and clear of what stands
/// around it: find_posture from postures drawn at random. theory/verification_plan.md eq. (1)-(3)
class TouchSearch {
 public:
  TouchSearch(const ArmModel& arm, VerificationRoom room);

  /// Why no artefact can be at a point, without a look at the arm's joints: "below the bench",
  /// "too near the first axis" (nearer than the column or a twentieth of the reach), "outside the
  /// measuring volume", "out of reach"; nothing where it may.
  /// @param clearance_mm  kept to bench and first axis, on top
  [[nodiscard]] std::optional<std::string> fault_at(const Eigen::Vector3d& point_mm,
                                                    double clearance_mm = 0.0) const;

  /// The posture for a touch that is nearest to a start, if it may be used.
  [[nodiscard]] std::optional<Eigen::VectorXd> posture_near(const Touch& touch,
                                                            const Eigen::VectorXd& start_rad) const;
  /// Up to `count` postures for a touch, from so many starts at most.
  [[nodiscard]] std::vector<Eigen::VectorXd> postures(const Touch& touch, std::size_t count,
                                                      int most_starts, RandomStream& random) const;
  /// Is a touch reached in more ways than one, as far as some dozen starts tell?
  [[nodiscard]] bool reaches(const Touch& touch, RandomStream& random) const;
  [[nodiscard]] Eigen::VectorXd random_posture(RandomStream& random) const;

  /// From the origin of the last joint to the tip, unit length.
  [[nodiscard]] Eigen::Vector3d stylus_direction(const Eigen::VectorXd& encoder_rad) const;
  /// How far the elbow stands out of the plane of the first axis and the tip, mm: positive to the
  /// left as seen from the base, with the first axis up. The elbow is the joint farthest from the
  /// straight line from the second joint to the tip. theory/verification_plan.md eq. (8)
  [[nodiscard]] double elbow_mm(const Eigen::VectorXd& encoder_rad) const;

  /// All that the tip can reach lies inside this ball.
  struct Ball {
    Eigen::Vector3d centre_mm;
    double radius_mm = 0.0;
  };
  [[nodiscard]] Ball outermost_reach() const;

  [[nodiscard]] const ArmModel& arm() const { return arm_; }
  [[nodiscard]] const VerificationRoom& room() const { return room_; }
  [[nodiscard]] Eigen::Vector3d tip(const Eigen::VectorXd& encoder_rad) const;
  /// Origin of the first joint, and its axis.
  [[nodiscard]] Eigen::Vector3d origin_mm() const;
  [[nodiscard]] Eigen::Vector3d up() const;
  /// Level direction from the first axis to a point; some level direction on the axis.
  [[nodiscard]] Eigen::Vector3d level_direction(const Eigen::Vector3d& point_mm) const;

 private:
  ArmModel arm_;
  VerificationRoom room_;
  ForwardKinematics kinematics_;
  JointLimits limits_;
};

/// The candidate that is farthest, in joint space, from the nearest of those chosen; the first of
/// equals, and the first of all where none is chosen. @param candidates  at least one
[[nodiscard]] const Eigen::VectorXd& farthest_from(const std::vector<Eigen::VectorXd>& chosen,
                                                   const std::vector<Eigen::VectorXd>& candidates);

}  // namespace armcal
