// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/verification_examples.h"

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
  return tables;
}

}  // namespace armcal::testing
