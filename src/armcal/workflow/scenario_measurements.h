// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "armcal/io/toml_value.h"
#include "armcal/simulation/artefacts/ball_bar.h"
#include "armcal/simulation/artefacts/calibrated_sphere.h"
#include "armcal/simulation/artefacts/cone_seat.h"
#include "armcal/simulation/artefacts/flat_surface.h"
#include "armcal/simulation/artefacts/indexed_platform.h"
#include "armcal/simulation/artefacts/multi_sphere_gauge.h"
#include "armcal/simulation/artefacts/sphere_plate.h"
#include "armcal/simulation/artefacts/straight_line.h"
#include "armcal/simulation/artefacts/two_seats.h"
#include "armcal/simulation/instruments/half_turns.h"
#include "armcal/simulation/instruments/laser_tracker.h"
#include "armcal/simulation/instruments/pose_tracker.h"
#include "armcal/simulation/instruments/reference_cmm.h"
#include "armcal/simulation/symmetric_procedure.h"

namespace armcal {

/// A symmetric-point procedure, carried out.
struct SymmetricPoint {
  std::string name = "symmetric-point";
  std::string procedure;  ///< path of its plan as written; empty: that of the 2016 paper
  SymmetricPractice practice;
};

/// What a scenario can measure with, by the options of the laboratory.
using Measurement =
    std::variant<ReferenceCmm, LaserTracker, PoseTracker, ConeSeat, TwoSeats, BallBar,
                 MultiSphereGauge, SpherePlate, StraightLine, CalibratedSphere, FlatSurface,
                 IndexedPlatform, HalfTurns, CircleRadii, SymmetricPoint>;

[[nodiscard]] const std::string& name_of(const Measurement& measurement);

/// A kind of measurement: how a scenario calls it, and the keys of its table.
struct MeasurementKind {
  std::string name;   ///< of `with`
  std::string brief;  ///< what it is, a few words
  std::vector<std::string> keys;
};
[[nodiscard]] std::vector<MeasurementKind> measurement_kinds();

/// Reads one [[measure]] of a scenario, to its end.
/// @return nothing where `with` names no kind
[[nodiscard]] std::optional<Measurement> read_measurement(TomlSection& section,
                                                          Diagnostics& diagnostics);

}  // namespace armcal
