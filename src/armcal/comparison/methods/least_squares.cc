// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "armcal/arm/estimability.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/comparison/bench_readings.h"
#include "armcal/comparison/methods/registry.h"
#include "armcal/simulation/artefacts/ball_bar.h"
#include "armcal/simulation/artefacts/cone_seat.h"
#include "armcal/simulation/artefacts/indexed_platform.h"
#include "armcal/simulation/artefacts/multi_sphere_gauge.h"
#include "armcal/simulation/artefacts/sphere_plate.h"
#include "armcal/simulation/artefacts/straight_line.h"
#include "armcal/simulation/instruments/laser_tracker.h"
#include "armcal/simulation/instruments/reference_cmm.h"

namespace armcal {
namespace {

// How many times a part of the readings fits into the budget, at least once.
int times(const Bench& bench, int readings_each) {
  return std::max(1, static_cast<int>(std::lround(1.0 * bench.readings / readings_each)));
}

// Least squares as `armcal calibrate` does it.
TakenReadings to_be_calibrated(const Bench& bench, std::vector<ObservationGroup> groups,
                               CalibrationOptions options = {}) {
  options.monitor = bench.monitor;
  state_encoders(bench, groups);
  const int count = count_readings(groups);
  return {count, [nominal = bench.arm.nominal(), groups = std::move(groups), options] {
            return found_arm(calibrate(nominal, groups, options));
          }};
}

template <class Artefact>
TakenReadings take(const Bench& bench, const Artefact& artefact, CalibrationOptions options = {}) {
  Laboratory laboratory = bench.laboratory();
  return to_be_calibrated(bench, measure(laboratory, artefact), std::move(options));
}

TakenReadings take_cmm(const Bench& bench, int harmonics) {
  return take(bench, ReferenceCmm{.count = bench.readings, .u_mm = bench.u_reference_mm},
              {.harmonics = harmonics});
}

TakenReadings take_tracker(const Bench& bench) {
  return take(bench, LaserTracker{.count = bench.readings, .u_distance_mm = bench.u_reference_mm});
}

// No cone knows how long a millimetre is: the longest length stays what the drawing says.
TakenReadings take_cone(const Bench& bench) {
  TakenReadings taken =
      take(bench, ConeSeat{.postures = bench.readings, .u_mm = bench.u_reference_mm},
           {.allow_rank_deficient = true});
  return {taken.count, [compute = std::move(taken.compute)] {
            FoundArm found = compute();
            found.remark = "longest length held: blind to scale";
            return found;
          }};
}

TakenReadings take_cone_and_length(const Bench& bench) {
  return to_be_calibrated(bench, cone_and_length(bench));
}

TakenReadings take_ball_bar(const Bench& bench) {
  return take(bench, BallBar{.placements = times(bench, 4), .u_mm = bench.u_reference_mm});
}

// Repeatability of every sphere and its distance from the first, and Fourier terms of the encoders.
TakenReadings take_gauge(const Bench& bench) {
  MultiSphereGauge gauge{.u_mm = bench.u_reference_mm,
                         .form = MultiSphereGauge::Form::points,
                         .u_length_mm = bench.u_length_mm};
  gauge.placements = times(bench, gauge.spheres * gauge.postures);
  return take(bench, gauge, {.harmonics = 2});
}

TakenReadings take_sphere_plate(const Bench& bench) {
  SpherePlate plate{.u_mm = bench.u_reference_mm};
  plate.placements = times(bench, plate.rows * plate.columns * plate.postures);
  return take(bench, plate);
}

TakenReadings take_straight_lines(const Bench& bench) {
  StraightLine line{.u_mm = bench.u_reference_mm};
  line.postures = times(bench, line.positions * line.directions);
  return take(bench, line);
}

// What moves the platform's own link only is not of the arm.
FoundArm standing_on_platform(const FoundArm& both) {
  FoundArm alone;
  alone.arm = without_platform(both.arm);
  alone.condition_number = both.condition_number;
  const ParameterTable table_of_both(both.arm);
  const ParameterTable table(alone.arm);
  std::vector<double> u;
  for (std::size_t i = 0; i < both.free.size(); ++i) {
    Parameter parameter = table_of_both[both.free[i]];
    --parameter.joint;
    for (int k = 0; k < table.size(); ++k) {
      const bool same = table[k].kind == parameter.kind && table[k].joint == parameter.joint &&
                        table[k].harmonic == parameter.harmonic;
      if (!same || held_by_convention(alone.arm, table[k])) continue;
      alone.free.push_back(k);
      u.push_back(both.u(static_cast<Eigen::Index>(i)));
    }
  }
  alone.u = Eigen::Map<Eigen::VectorXd>(u.data(), static_cast<Eigen::Index>(u.size()));
  return alone;
}

TakenReadings take_platform(const Bench& bench) {
  IndexedPlatform platform{.u_mm = bench.u_reference_mm};
  platform.points = times(bench, platform.positions);
  Laboratory laboratory = bench.laboratory();
  std::vector<ObservationGroup> groups = measure(laboratory, platform);
  state_encoders(bench, groups);
  const int count = count_readings(groups);
  return {
      count, [nominal = on_platform(bench.arm.nominal(), platform), groups = std::move(groups),
              monitor = bench.monitor] {
        return standing_on_platform(found_arm(calibrate(nominal, groups, {.monitor = monitor})));
      }};
}

}  // namespace

std::vector<Method> least_squares_methods() {
  return {
      {.name = "cmm",
       .title = "least squares, reference CMM",
       .reference = "Wang P., Fei et al. 2007",
       .needs = "a coordinate measuring machine",
       .take = [](const Bench& bench) { return take_cmm(bench, 0); }},
      {.name = "cmm-harmonics",
       .title = "the same with two harmonics",
       .needs = "a coordinate measuring machine",
       .take = [](const Bench& bench) { return take_cmm(bench, 2); }},
      {.name = "tracker",
       .title = "least squares, laser tracker",
       .needs = "a laser tracker",
       .take = take_tracker},
      {.name = "cone", .title = "least squares, one cone", .needs = "a cone", .take = take_cone},
      {.name = "cone-and-length",
       .title = "least squares, two cones and their distance",
       .needs = "two cones of known distance",
       .take = take_cone_and_length},
      {.name = "ball-bar",
       .title = "least squares, ball bar",
       .needs = "a ball bar",
       .effort = 25.0,
       .take = take_ball_bar},
      {.name = "gauge",
       .title = "14-sphere gauge, Fourier terms",
       .reference = "Santolaria et al. 2008",
       .needs = "a gauge with 14 spheres",
       .effort = 40.0,
       .take = take_gauge},
      {.name = "sphere-plate",
       .title = "sphere plate",
       .reference = "Furutani et al. 2004",
       .needs = "a plate with spheres",
       .take = take_sphere_plate},
      {.name = "straight-lines",
       .title = "straight lines in six directions",
       .reference = "Kovac, Klein 2002",
       .needs = "a device of calibrated positions along a line",
       .take = take_straight_lines},
      {.name = "platform",
       .title = "indexed platform",
       .reference = "Acero et al. 2015",
       .needs = "an indexed platform and a gauge",
       .take = take_platform}};
}

}  // namespace armcal
