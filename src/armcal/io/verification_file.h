// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/io/reading_tables.h"
#include "armcal/io/stated_limit.h"
#include "armcal/io/text_file.h"
#include "armcal/io/verification_artefact.h"

namespace armcal {

/// The tests that a verification file can ask for.
enum class StatedTestKind {
  probing,                    ///< ISO 10360-12: size and form
  articulated_location,       ///< ISO 10360-12
  length_uni,                 ///< ISO 10360-12
  length_bi,                  ///< ISO 10360-12
  effective_diameter,         ///< ASME B89.4.22
  single_point_articulation,  ///< ASME B89.4.22
  volumetric_length,          ///< ASME B89.4.22
  half_range,                 ///< of no standard: the makers' quick form
};
[[nodiscard]] std::string_view to_string(StatedTestKind kind);
[[nodiscard]] bool is_of_iso(StatedTestKind kind);
[[nodiscard]] bool measures_lengths(StatedTestKind kind);
[[nodiscard]] bool needs_sphere(StatedTestKind kind);
/// Has it two statistics, each with its limit?
[[nodiscard]] bool has_two_limits(StatedTestKind kind);

/// One [[test]]: what was measured on which artefact, and the limits that it has to keep.
struct StatedTest {
  SourcePosition where;
  StatedTestKind kind = StatedTestKind::probing;
  std::string name;
  std::string artefact;  ///< empty: a seat, of which nothing is certified
  std::string file;
  double probe_diameter_mm = 0.0;
  double u_repeatability_mm = 0.0;   ///< of what the test adds itself: fixture, clamping
  std::optional<StatedLimit> limit;  ///< the first statistic of the kind: `mpe_um`, `mpe_size_um`
  std::optional<StatedLimit> second_limit;  ///< the second: `mpe_form_um`, `mpe_2s_um`, ..
  TableOptions table;
};

/// [decision]: how a value is judged against its limit.
struct StatedDecision {
  std::string rule = "iso14253-1";
  double coverage_factor = 2.0;
  double probability = 0.95;  ///< conformance-probability
  double guard_factor = 1.0;  ///< guard-band: share of U
};

/// [environment]
struct StatedEnvironment {
  double temperature_C = 20.0;
  double u_temperature_K = 0.0;
};

struct VerificationFile {
  std::string file;
  std::string name;
  std::string arm_file;      ///< resolved; empty: the tables hold coordinates
  std::string as_left_file;  ///< resolved; empty: one arm is judged
  std::optional<double> reach_mm;
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();  ///< of the first axis, for coordinates
  StatedDecision decision;
  StatedEnvironment environment;
  std::vector<StatedArtefact> artefacts;
  std::vector<StatedTest> tests;

  /// @return null where none is called so
  [[nodiscard]] const StatedArtefact* artefact(std::string_view called) const;
};

/// Reads a *.verification.toml (schema armcal.verification/1: docs/files/verification.md). Problems
/// go to `diagnostics`; with errors nothing is returned.
[[nodiscard]] std::optional<VerificationFile> read_verification_file(const TextFile& file,
                                                                     Diagnostics& diagnostics);

}  // namespace armcal
