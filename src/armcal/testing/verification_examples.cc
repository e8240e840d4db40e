// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/verification_examples.h"

#include <Eigen/LU>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/testing/verification_readings.h"

namespace armcal::testing {
namespace {

// As in examples/verification/*.verification.toml. The laboratory has 20 degC.
constexpr double kSphere_mm = 24.9987;
constexpr double kProbe_mm = 6.0;
constexpr double kTouching_mm = (kSphere_mm + kProbe_mm) / 2.0;
const std::vector<double> kStepGauge_mm = {220.0008, 440.0013, 660.0021, 880.0024, 1100.0035};
constexpr double kShortBar_mm = 900.0017;
constexpr double kLongBar_mm = 1400.0042;

// Along and across the volume in front of the arm.
std::vector<PlacedBar> seven_positions() {
  const auto bar = [](const char* name, Eigen::Vector3d middle_mm, const Eigen::Vector3d& along) {
    const Eigen::Vector3d direction = along.normalized();
    return PlacedBar{name, middle_mm - kStepGauge_mm.back() / 2.0 * direction, direction,
                     kStepGauge_mm};
  };
  return {bar("x", {750, 150, 100}, {1, 0, 0}),
          bar("y", {700, 0, 0}, {0, 1, 0}),
          bar("z", {650, -200, 100}, {0, 0, 1}),
          bar("xy", {550, 550, 200}, {1, -1, 0}),
          bar("yz", {-600, 200, 150}, {0, 1, 1}),
          bar("xz", {200, 700, 200}, {1, 0, 1}),
          bar("space diagonal", {100, -650, 250}, {1, 1, 1})};
}

// Twenty placements about the arm: directions in all octants, two lengths by turns.
std::vector<PlacedBar> twenty_placements() {
  std::vector<PlacedBar> bars;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < 20; ++i) {
    const double length = i % 2 == 0 ? kShortBar_mm : kLongBar_mm;
    const Eigen::Vector3d middle_mm(500.0 * std::cos(0.9 * i), 500.0 * std::sin(0.9 * i),
                                    -200.0 + 25.0 * i);
    const double z = -0.95 + 0.1 * i;
    const double r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d direction(r * std::cos(golden * i), r * std::sin(golden * i), z);
    bars.push_back(
        {std::to_string(i + 1), middle_mm - length / 2.0 * direction, direction, {length}});
  }
  return bars;
}

// A posture and the sphere of the 2016 paper that its tip touches first.
struct StillPosture {
  std::string name;
  std::vector<double> posture_deg;
};

// The posture with joints 1, 2 and 4 moved so that the tip is on a point.
Eigen::VectorXd with_still_wrist(const ForwardKinematics& kinematics, Eigen::VectorXd encoder_rad,
                                 const Eigen::Vector3d& point_mm) {
  constexpr int kIterations = 20;  // of Newton; a few degrees away it needs five
  TipLinearisation at;
  for (int i = 0; i < kIterations; ++i) {
    kinematics.linearise({encoder_rad.data(), static_cast<std::size_t>(encoder_rad.size())}, at);
    Eigen::Matrix3d J;
    J << at.J_tip_encoder.col(0), at.J_tip_encoder.col(1), at.J_tip_encoder.col(3);
    const Eigen::Vector3d step = J.partialPivLu().solve(point_mm - at.tip_mm);
    encoder_rad(0) += step(0);
    encoder_rad(1) += step(1);
    encoder_rad(3) += step(2);
  }
  return encoder_rad;
}

std::string still_wrist_table(Laboratory& laboratory, const std::vector<StillPosture>& postures) {
  constexpr double kTouchingPaper_mm = (15.8754 + kProbe_mm) / 2.0;
  const ForwardKinematics kinematics(laboratory.arm().truth());
  VerificationTable table(laboratory, "position,point");
  for (const StillPosture& still : postures) {
    Eigen::VectorXd start_rad(6);
    for (Eigen::Index j = 0; j < 6; ++j) {
      start_rad(j) = radians_from_degrees(still.posture_deg[static_cast<std::size_t>(j)]);
    }
    const auto directions = probing_directions(25);
    const Eigen::Vector3d center_mm =
        kinematics.tip_in_base({start_rad.data(), 6}) - kTouchingPaper_mm * directions.front();
    int number = 0;
    for (const Eigen::Vector3d& direction : directions) {
      const Eigen::Vector3d point_mm = center_mm + kTouchingPaper_mm * direction;
      table.add(fmt::format("{},{}", still.name, ++number), point_mm,
                with_still_wrist(kinematics, start_rad, point_mm));
    }
  }
  return table.text();
}

}  // namespace

std::map<std::string, std::string> verification_example_tables(const ArmModel& truth) {
  ErrorSources errors;
  errors.encoder_noise.u_rad = radians_from_arcseconds(1.0);
  Laboratory laboratory(VirtualArm(truth, truth, errors, 1), 1);
  std::map<std::string, std::string> tables;
  int measurement = 0;
  const auto next = [&]() -> Laboratory& {
    laboratory.begin(++measurement);
    return laboratory;
  };
  tables["probing.csv"] = probing_table(
      next(), {{"near", {450, 100, 100}}, {"far", {-300, 1000, 300}}}, kTouching_mm, 25);
  tables["articulations.csv"] = articulation_table(next(), {600, -300, 150}, kTouching_mm, 5, 5);
  tables["lengths.csv"] = length_table(next(), seven_positions(), 3);
  tables["diameters.csv"] =
      probing_table(next(), {{"1", {600, 200, 0}}, {"2", {600, 200, 0}}, {"3", {600, 200, 0}}},
                    kTouching_mm, 9, "repeat");
  tables["seats.csv"] = seat_table(
      next(), {{"near", {250, 0, 100}}, {"middle", {600, 400, 100}}, {"far", {-900, 900, 300}}},
      10);
  tables["twenty-lengths.csv"] = length_table(next(), twenty_placements(), 1, "placement");
  tables["still-wrist.csv"] = still_wrist_table(
      next(), {{"left", {-171, 41, 10, 66, 55, 85}}, {"right", {109, 58, 1, 83, 83, -23}}});
  return tables;
}

}  // namespace armcal::testing
