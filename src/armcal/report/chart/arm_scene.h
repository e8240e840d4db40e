// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/arm/arm_model.h"

namespace armcal {

/// An arm as it was read, by encoder readings.
struct ScenePosture {
  std::string name;
  Eigen::VectorXd q_rad;
  std::optional<Eigen::Vector3d> residual_mm;  ///< measured - predicted, in the base frame
  bool is_check = false;                       ///< not used by the fit
};

enum class ArtefactShape { point, sphere, bar };

/// What the arm measured.
struct SceneArtefact {
  ArtefactShape shape = ArtefactShape::point;
  std::string name;
  Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_mm = Eigen::Vector3d::Zero();  ///< other end of a bar
  double radius_mm = 0.0;
};

/// An arm in space with what was done with it. All coordinates in its base frame.
struct ArmScene {
  ArmModel arm;
  std::optional<ArmModel> nominal;
  std::vector<ScenePosture> postures;
  /// Joint, from 0, whose half turn leads from the first posture to the second; there are no
  /// others.
  std::optional<int> turning_joint;
  std::vector<SceneArtefact> artefacts;
  double enlargement = 1.0;  ///< of residuals
};

/// Can the posture be shown: has it one finite reading for each joint of a sound arm?
[[nodiscard]] bool can_stand(const ArmModel& arm, const ScenePosture& posture);

/// The scene for a script, as JSON: docs/theory/report.md. The arm is complete, and its numbers
/// read back the same: tips are those of this arm to rounding. At most 500 postures: the half of
/// them that have the largest residuals, and of the others some at even steps.
[[nodiscard]] std::string live_scene(const ArmScene& scene);

/// 1, 2 or 5 times a power of ten that draws a large residual, than which one in twenty is larger,
/// about a tenth of the arm's reach long; 1 where there are none. A few readings that do not belong
/// to the others do not make all others invisible.
[[nodiscard]] double nice_enlargement(const ArmScene& scene);

}  // namespace armcal
