// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "armcal/report/chart/arm_scene.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// A scene with the words around it.
struct ArmDrawing {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;     ///< said where no posture can be shown
  std::string fit, check;  ///< words of the legend
  std::string arrows;      ///< what arrows are, with their enlargement: there too
  ArmScene scene;
  std::size_t shown = 0;  ///< posture at which the arm is drawn; of the others only tips are
};

/// The arm in space on a ground with a grid and a scale bar, its joints numbered; residuals as
/// arrows from where the arm says that its tip was to where it was, dashed where they had to be
/// cut; artefacts with their names. Seen from the side from which its links cover each other least.
[[nodiscard]] Figure figure_of(const ArmDrawing& drawing);

/// A point that is reached at two postures, of which one follows from the other by half a turn of
/// a joint.
struct HalfTurnDrawing {
  std::string id;
  std::string title;
  std::string text;
  std::string nothing;
  ArmModel arm;
  Eigen::VectorXd a_rad, b_rad;  ///< encoder readings
  int joint = 0;                 ///< that turns, from 0
  std::string joint_name;
  std::string a_name = "A", b_name = "B";
  std::string distance;  ///< between the tips: "612.304 mm"
};

/// The arm at A drawn solid and at B dashed, the joint that turns in colour with its axis, and the
/// way from A to B with its length.
[[nodiscard]] Figure figure_of(const HalfTurnDrawing& drawing);

}  // namespace armcal
