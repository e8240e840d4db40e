// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/scenario_measurements.h"

#include <fmt/format.h>

#include "armcal/core/spelling.h"
#include "armcal/workflow/scenario_keys.h"

namespace armcal {
namespace {

using namespace scenario_key;
constexpr AmountRange kPositive = AmountRange::positive;

template <class Options>
using Keys = std::vector<ScenarioKey<Options>>;

Keys<ReferenceCmm> keys_of(const ReferenceCmm&) {
  using T = ReferenceCmm;
  return {count("count", &T::count), amount("u_mm", &T::u_mm)};
}

Keys<LaserTracker> keys_of(const LaserTracker&) {
  using T = LaserTracker;
  return {count("count", &T::count), amount("distance_mm", &T::distance_mm, kPositive),
          amount("u_distance_mm", &T::u_distance_mm), angle("u_angle", &T::u_angle_rad)};
}

Keys<PoseTracker> keys_of(const PoseTracker&) {
  using T = PoseTracker;
  return {count("count", &T::count), amount("distance_mm", &T::distance_mm, kPositive),
          amount("u_mm", &T::u_mm), angle("u_turn", &T::u_turn_rad)};
}

Keys<ConeSeat> keys_of(const ConeSeat&) {
  using T = ConeSeat;
  return {count("seats", &T::seats), count("postures", &T::postures), amount("u_mm", &T::u_mm)};
}

Keys<TwoSeats> keys_of(const TwoSeats&) {
  using T = TwoSeats;
  return {amount("length_mm", &T::length_mm, kPositive), amount("u_length_mm", &T::u_length_mm),
          count("placements", &T::placements), count("postures", &T::postures),
          amount("u_mm", &T::u_mm)};
}

Keys<BallBar> keys_of(const BallBar&) {
  using T = BallBar;
  return {amount("length_mm", &T::length_mm, kPositive), count("placements", &T::placements),
          count("postures", &T::postures), amount("u_mm", &T::u_mm)};
}

Keys<MultiSphereGauge> keys_of(const MultiSphereGauge&) {
  using T = MultiSphereGauge;
  return {count("spheres", &T::spheres, 2),
          amount("pitch_mm", &T::pitch_mm, kPositive),
          count("placements", &T::placements),
          count("postures", &T::postures),
          amount("u_mm", &T::u_mm),
          choice("form", &T::form, {"artefact", "points"}, {T::Form::artefact, T::Form::points}),
          amount("u_length_mm", &T::u_length_mm)};
}

Keys<SpherePlate> keys_of(const SpherePlate&) {
  using T = SpherePlate;
  return {count("rows", &T::rows),
          count("columns", &T::columns),
          amount("pitch_mm", &T::pitch_mm, kPositive),
          count("placements", &T::placements),
          count("postures", &T::postures),
          amount("u_mm", &T::u_mm)};
}

Keys<StraightLine> keys_of(const StraightLine&) {
  using T = StraightLine;
  return {amount("length_mm", &T::length_mm, kPositive), count("positions", &T::positions, 2),
          count("directions", &T::directions), count("postures", &T::postures),
          amount("u_mm", &T::u_mm)};
}

Keys<CalibratedSphere> keys_of(const CalibratedSphere&) {
  using T = CalibratedSphere;
  return {amount("diameter_mm", &T::diameter_mm, kPositive),
          amount("tip_radius_mm", &T::tip_radius_mm),
          count("placements", &T::placements),
          count("points", &T::points, 4),
          amount("u_mm", &T::u_mm),
          yes_no("is_known", &T::is_known)};
}

Keys<FlatSurface> keys_of(const FlatSurface&) {
  using T = FlatSurface;
  return {amount("size_mm", &T::size_mm, kPositive), count("placements", &T::placements),
          count("points", &T::points, 3), amount("u_mm", &T::u_mm)};
}

Keys<IndexedPlatform> keys_of(const IndexedPlatform&) {
  using T = IndexedPlatform;
  return {count("positions", &T::positions), count("points", &T::points, 3),
          count("postures", &T::postures),   amount("u_mm", &T::u_mm),
          angle("u_index", &T::u_index_rad), amount("radius_mm", &T::radius_mm)};
}

Keys<HalfTurns> keys_of(const HalfTurns&) {
  using T = HalfTurns;
  return {count("count", &T::count), counts("joints", &T::joints), amount("u_mm", &T::u_mm)};
}

Keys<CircleRadii> keys_of(const CircleRadii&) {
  using T = CircleRadii;
  return {count("count", &T::count), counts("joints", &T::joints),
          angle("arc", &T::arc_rad, kPositive), amount("u_mm", &T::u_mm)};
}

Keys<SymmetricPractice> keys_of(const SymmetricPractice&) {
  using T = SymmetricPractice;
  return {amount("u_point_mm", &T::u_point_mm),
          count("repeats", &T::repeats),
          count("arc_points", &T::arc_points, 3),
          angle("arc", &T::arc_rad, kPositive),
          count("zero_settings", &T::zero_settings, 3),
          angle("zero_range", &T::zero_range_rad, kPositive),
          angle("u_posture", &T::u_posture_rad),
          angle("u_slip", &T::u_slip_rad),
          angle("u_half_turn", &T::u_half_turn_rad)};
}

// A procedure comes from a file; how it is carried out are keys of the same table.
Keys<SymmetricPoint> keys_of(const SymmetricPoint&) {
  Keys<SymmetricPoint> keys = {text("procedure", &SymmetricPoint::procedure)};
  for (const ScenarioKey<SymmetricPractice>& key : keys_of(SymmetricPractice{})) {
    keys.push_back(
        {key.name, [key](TomlSection& section, SymmetricPoint& options, Diagnostics& diagnostics) {
           key.read(section, options.practice, diagnostics);
         }});
  }
  return keys;
}

struct Definition {
  MeasurementKind kind;
  std::function<Measurement(TomlSection&, Diagnostics&)> read;
};

template <class Options>
Definition definition(const char* name, const char* brief) {
  const auto keys = keys_of(Options{});
  return {{name, brief, names_of(keys)}, [keys](TomlSection& section, Diagnostics& diagnostics) {
            Options options;
            options.name = section.text("name").value_or(options.name);
            read_keys(section, keys, options, diagnostics);
            section.finish();
            return options;
          }};
}

// A new kind of measurement is a line here, its keys above, and its place in `Measurement`.
std::vector<Definition> definitions() {
  return {
      definition<ReferenceCmm>("reference_cmm", "a CMM that measures the same points"),
      definition<LaserTracker>("laser_tracker", "a tracker and a reflector on the tip"),
      definition<PoseTracker>("pose_tracker", "a tracker and a target of six degrees of freedom"),
      definition<ConeSeat>("cone_seat", "cones that hold the tip"),
      definition<TwoSeats>("two_seats", "two cones on a bar of known length"),
      definition<BallBar>("ball_bar", "a bar with two spheres, in many placements"),
      definition<MultiSphereGauge>("multi_sphere_gauge", "a long bar with many spheres"),
      definition<SpherePlate>("sphere_plate", "a plate with spheres in a square pattern"),
      definition<StraightLine>("straight_line", "known positions along lines"),
      definition<CalibratedSphere>("calibrated_sphere", "the surface of a sphere"),
      definition<FlatSurface>("flat_surface", "a surface plate"),
      definition<IndexedPlatform>("indexed_platform", "the arm on a platform, over a fixed gauge"),
      definition<HalfTurns>("half_turns", "half turns of single joints"),
      definition<CircleRadii>("circle_radii", "circles of the tip about single joints"),
      definition<SymmetricPoint>("symmetric_point", "a symmetric-point procedure, as raw points"),
  };
}

}  // namespace

const std::string& name_of(const Measurement& measurement) {
  return std::visit([](const auto& options) -> const std::string& { return options.name; },
                    measurement);
}

std::vector<MeasurementKind> measurement_kinds() {
  std::vector<MeasurementKind> kinds;
  for (const Definition& each : definitions()) kinds.push_back(each.kind);
  return kinds;
}

std::optional<Measurement> read_measurement(TomlSection& section, Diagnostics& diagnostics) {
  const auto with = section.required_text("with");
  if (!with) return std::nullopt;
  std::vector<std::string> names;
  for (const Definition& each : definitions()) {
    if (each.kind.name == *with) return each.read(section, diagnostics);
    names.push_back(each.kind.name);
  }
  diagnostics.error(section.where("with"), fmt::format("nothing measures with \"{}\"", *with),
                    did_you_mean(*with, names));
  return std::nullopt;
}

}  // namespace armcal
