// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "armcal/report/html/document_view.h"

namespace armcal {

/// One row of readings of a calibration, from the columns of the key `rows`.
struct ResidualRow {
  std::string group;
  std::string place;  ///< "readings/cmm.csv:118"
  std::string label;  ///< "cmm.csv:118" where no other file has that name, else as `place`
  bool is_check = false;
  double residual_mm = 0.0;
  double normalised = 0.0;
  double u_mm = 0.0;
  std::optional<double> time_s;           ///< since 1970, or since a start that all rows share
  std::vector<double> q_deg;              ///< encoder readings; empty where the row has no posture
  std::optional<Eigen::Vector3d> tip_mm;  ///< in the base frame
  std::optional<Eigen::Vector3d> residual_vector_mm;  ///< in the base frame
  std::vector<double> components;                     ///< residuals over their stated uncertainties
};

/// @throws InputError where columns differ in length or hold what they should not
[[nodiscard]] std::vector<ResidualRow> residual_rows(const DocumentView& document);

}  // namespace armcal
