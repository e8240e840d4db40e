// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/io/csv_table.h"
#include "armcal/io/verification_file.h"

namespace armcal {

/// Rows of the table of one test. What they measured is one of three: joint angles, coordinates, or
/// lengths that the arm's own software gave. A column that is not there is an empty vector.
struct VerificationRows {
  std::string file;
  std::vector<int> lines;
  Eigen::MatrixXd encoder_rad;  ///< joints x rows
  std::vector<Eigen::Vector3d> points_mm;
  std::vector<double> measured_mm;
  std::vector<std::string> place;  ///< column `position`, or else `placement`
  std::vector<std::string> articulation;
  std::vector<std::string> repeat;
  std::vector<char> end;            ///< 'A' or 'B'
  std::vector<std::size_t> length;  ///< which of the artefact's lengths

  [[nodiscard]] std::size_t count() const { return lines.size(); }
  [[nodiscard]] bool has_angles() const { return encoder_rad.size() > 0; }
  [[nodiscard]] bool has_measured_lengths() const { return !measured_mm.empty(); }
};

/// A calibrated length that a table calls by its nominal value differs from it by less than this.
inline constexpr double kNominalWithin_mm = 1.0;

/// Calibrated lengths of an artefact from its table: length_mm, U_um, and where they have names,
/// name (else 1, 2, ..). Problems go to `diagnostics`; with errors nothing is returned.
[[nodiscard]] std::optional<std::vector<CertifiedLength>> certified_lengths(
    const CsvTable& table, Diagnostics& diagnostics);

/// The rows of a test. In a table with a column `test`, those whose `test` is the name or the kind
/// of this one; else all. Strict as all tables of readings are, and about what the kind of test
/// needs: its columns, ends A and B, lengths that the artefact has.
/// @param artefact     null for a test in a seat
/// @param joint_count  0: no arm is given, the table must hold coordinates or measured lengths
/// @return nothing after an error, which is in `diagnostics`
[[nodiscard]] std::optional<VerificationRows> verification_rows(const CsvTable& table,
                                                                const StatedTest& test,
                                                                const StatedArtefact* artefact,
                                                                int joint_count,
                                                                Diagnostics& diagnostics);

}  // namespace armcal
