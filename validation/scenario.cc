// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "scenario.h"

#include <stdexcept>

#include "armcal/core/units.h"
#include "armcal/io/arm_file.h"
#include "armcal/simulation/artefacts/sphere_plate.h"
#include "armcal/simulation/artefacts/two_seats.h"
#include "armcal/simulation/instruments/half_turns.h"
#include "armcal/simulation/instruments/reference_cmm.h"

namespace armcal::validation {
namespace {

constexpr double kEncoder_rad = radians_from_arcseconds(2.0);
constexpr ScaleEccentricity kEccentricity = {.u_first_rad = radians_from_arcseconds(10.0),
                                             .u_second_rad = radians_from_arcseconds(4.0)};

ArmModel arm_of(const std::string& path) {
  Diagnostics diagnostics;
  const auto file = read_text_file(path, kLargestConfiguration_bytes, diagnostics);
  auto arm = file ? read_arm(*file, diagnostics) : std::nullopt;
  if (!arm) throw std::runtime_error(path + " cannot be read");
  return std::move(*arm);
}

std::vector<ObservationGroup> by_cmm(Laboratory& laboratory) {
  return measure(laboratory, ReferenceCmm{.count = 100, .u_mm = 0.003});
}

std::vector<ObservationGroup> by_cone_and_length(Laboratory& laboratory) {
  return measure(laboratory, TwoSeats{.length_mm = 500.0,
                                      .u_length_mm = 0.001,
                                      .placements = 3,
                                      .postures = 30,
                                      .u_mm = 0.005});
}

std::vector<ObservationGroup> by_sphere_plate(Laboratory& laboratory) {
  return measure(laboratory, SpherePlate{.placements = 8, .postures = 3, .u_mm = 0.005});
}

std::vector<ObservationGroup> by_half_turns(Laboratory& laboratory) {
  return measure(laboratory, HalfTurns{.count = 200, .u_mm = 0.005});
}

}  // namespace

std::vector<Scenario> all_scenarios(const std::string& examples) {
  const ArmModel six = arm_of(examples + "/arms/romer-infinite-2.0.arm.toml");
  const ArmModel seven = arm_of(examples + "/arms/seven-joint.arm.toml");
  return {
      {.name = "reference-cmm",
       .description = "six joints, 100 points of a reference CMM, 3 um",
       .nominal = six,
       .measure = by_cmm},
      {.name = "cone-and-length",
       .description = "six joints, 180 postures in two cones 500 mm (1 um) apart in three places, "
                      "5 um",
       .nominal = six,
       .measure = by_cone_and_length,
       .u_held_out_mm = 0.005},
      {.name = "sphere-plate",
       .description = "six joints, nine spheres in eight places, three postures each, 5 um",
       .nominal = six,
       .measure = by_sphere_plate,
       .u_held_out_mm = 0.005},
      {.name = "half-turns",
       .description = "six joints, 200 half turns, 5 um, by the symmetric-point adjustment",
       .nominal = six,
       .measure = by_half_turns,
       .by_adjustment = true,
       .u_held_out_mm = 0.005},
      {.name = "noisy-encoders",
       .description = "six joints, 100 points of a reference CMM, 3 um; encoders of 2 arcsec",
       .nominal = six,
       .measure = by_cmm,
       .u_encoder_rad = kEncoder_rad},
      {.name = "half-turns-noisy-encoders",
       .description = "six joints, 200 half turns, 5 um, by identification; encoders of 2 arcsec",
       .nominal = six,
       .measure = by_half_turns,
       .u_encoder_rad = kEncoder_rad,
       .u_held_out_mm = 0.005},
      {.name = "seven-joints",
       .description = "seven joints, 100 points of a reference CMM, 3 um",
       .nominal = seven,
       .measure = by_cmm},
      {.name = "eccentric-scales-not-modelled",
       .description = "as reference-cmm, scales that err by 10 arcsec once and 4 arcsec twice per "
                      "turn, not modelled",
       .nominal = six,
       .measure = by_cmm,
       .eccentricity = kEccentricity,
       .model_is_complete = false},
      {.name = "eccentric-scales-modelled",
       .description = "the same with two harmonics per joint",
       .nominal = six,
       .measure = by_cmm,
       .options = {.harmonics = 2},
       .eccentricity = kEccentricity,
       .largest_rms_ratio = 1.2},
  };
}

}  // namespace armcal::validation
