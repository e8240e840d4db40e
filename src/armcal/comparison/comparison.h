// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "armcal/comparison/scenario.h"
#include "armcal/comparison/score.h"
#include "armcal/core/progress.h"

namespace armcal {

struct ComparisonOptions {
  std::vector<std::string> methods = {"*"};  ///< names or globs
  std::uint64_t seed = 1;                    ///< of the first arm; each further one has the next
  int repeats = 1;                           ///< arms
  int threads = 1;                           ///< never changes a digit, except of times
  Monitor monitor;
};

/// One method over all arms. Figures are medians over the arms for which it found something.
struct ComparisonRow {
  std::string name, title, reference, needs;
  int readings = 0;
  int arms = 0;                            ///< for which it found an arm
  Score score;                             ///< counts of intervals are sums
  double seconds = 0.0;                    ///< of computing, without the taking of readings
  std::optional<double> condition_number;  ///< of the first arm
  std::string remark;                      ///< of the first arm
  std::string problem;  ///< why it found nothing, first such arm; empty where it always did
};

struct Comparison {
  Scenario scenario;
  std::uint64_t seed = 1;
  int repeats = 1;
  double noise_floor_mm = 0.0;  ///< median
  std::vector<ComparisonRow> rows;
};

/// Every chosen method on the same arms. A method that cannot work here has its reason in its row.
/// @throws std::invalid_argument where no method is called so, or without an arm; Interrupted
[[nodiscard]] Comparison compare_methods(const Scenario& scenario,
                                         const ComparisonOptions& options);

}  // namespace armcal
