// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/io/reading_tables.h"
#include "armcal/io/text_file.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

class TomlSection;

/// One [[observations]] of a session: which file, what kind, and what holds for all of its rows.
struct SessionGroup {
  std::string name;
  ReferenceKind kind = ReferenceKind::reference_points;
  SourcePosition where;
  std::string
      file;  ///< path, resolved from the place of the session; empty for a length given in place
  std::string artefact_file;  ///< artefact: calibrated coordinates of its features
  TableOptions table;
  std::optional<double> u_mm;
  double u_encoder_rad = 0.0;
  std::string set;       ///< "fit", "check" or empty: not said
  std::string place;     ///< set-up, placement, point, sphere or plane where no column names it
  std::string place_to;  ///< length: the second point
  std::optional<double> length_mm;
  std::optional<int> joint;  ///< reversal, circle_radius
  double turn_rad = 0.0;     ///< reversal
  std::optional<double> radius_mm;
  double tip_radius_mm = 0.0;
  double lever_mm = 100.0;
  Eigen::Vector3d offset_mm = Eigen::Vector3d::Zero();
  std::string target;
};

/// What a session wants estimated, and from which rows.
struct SessionEstimate {
  std::vector<std::string> hold;
  std::optional<double> prior_length_mm, prior_zero_rad, prior_twist_rad, prior_harmonic_rad;
  std::map<std::string, double> prior_of;  ///< by parameter, mm or rad
  int harmonics = 0;
  std::string loss = "none";
  double check_fraction = 0.0;
  std::uint64_t check_seed = 1;
};

struct Session {
  std::string file;
  std::string name;
  std::string arm_file;  ///< resolved
  std::vector<SessionGroup> groups;
  SessionEstimate estimate;
};

/// Reads a *.session.toml (schema armcal.session/1: docs/files/session.md). Problems go to
/// `diagnostics`; with errors nothing is returned.
[[nodiscard]] std::optional<Session> read_session_file(const TextFile& file,
                                                       Diagnostics& diagnostics);

/// The key `angles`: unit of angle columns that name none.
[[nodiscard]] std::optional<AngleUnit> angle_unit_of(TomlSection& section,
                                                     Diagnostics& diagnostics);

/// Reads a table [estimate], to its end.
[[nodiscard]] SessionEstimate read_session_estimate(TomlSection& section, Diagnostics& diagnostics);

/// The key under which a kind's place is named where no column does: setup, placement, point,
/// sphere, plane, from; null where a kind has none.
[[nodiscard]] const char* place_key(ReferenceKind kind);

}  // namespace armcal
