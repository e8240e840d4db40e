// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "armcal/comparison/row_figures.h"
#include "armcal/core/progress.h"
#include "armcal/identification/calibration.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

struct SessionComparisonOptions {
  std::vector<std::string> methods = {"*"};  ///< names or globs
  std::uint64_t seed = 1;                    ///< of searches without derivatives
  int threads = 1;                           ///< never changes a digit, except of times
  Monitor monitor;
};

/// One method on the readings of a session.
struct SessionComparisonRow {
  std::string name, title;
  int parameters = 0;  ///< of the arm that were estimated
  std::optional<double> condition_number;
  std::optional<RowFigures> fitted;
  std::optional<RowFigures> held_out;
  double seconds = 0.0;
  std::string remark;
  std::string problem;  ///< why it found nothing, or cannot be judged
};

/// Methods on the readings of one session.
struct SessionComparison {
  std::string arm_name;
  Eigen::Index fitted = 0;    ///< rows
  Eigen::Index held_out = 0;  ///< rows that judge
  bool split_here = false;    ///< the session itself holds nothing out
  std::vector<SessionComparisonRow> rows;
};

/// Every method that needs no reading of its own, on the same readings, judged on those that were
/// held out.
/// @param groups   some of whose rows are held out
/// @param options  what the session wants held, its priors, loss and harmonics
/// @throws std::invalid_argument where no method is called so, or no row is held out; Interrupted
[[nodiscard]] SessionComparison compare_on_session(const ArmModel& nominal,
                                                   std::span<const ObservationGroup> groups,
                                                   const CalibrationOptions& calibration,
                                                   const SessionComparisonOptions& options);

}  // namespace armcal
