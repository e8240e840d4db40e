// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/comparison_job.h"

#include <algorithm>

#include "armcal/observations/check_split.h"
#include "armcal/workflow/calibration_job.h"

namespace armcal {
namespace {

Eigen::Index held_out_rows(const std::vector<ObservationGroup>& groups) {
  Eigen::Index count = 0;
  for (const ObservationGroup& group : groups)
    count += std::count(group.is_check.begin(), group.is_check.end(), true);
  return count;
}

}  // namespace

SessionComparison run_session_comparison(InputFiles& files, const std::string& path,
                                         const SessionComparisonOptions& options) {
  LoadedSession loaded = load_session(files, path);
  const bool split_here = held_out_rows(loaded.groups) == 0;
  if (split_here) {
    hold_out(loaded.groups, kSplitForComparison, loaded.session.estimate.check_seed);
  }
  if (held_out_rows(loaded.groups) == 0) {
    throw NumericalError(loaded.session.file + ": too few rows to hold some out to judge by");
  }
  SessionComparison comparison =
      compare_on_session(loaded.arm, loaded.groups, loaded.options, options);
  comparison.split_here = split_here;
  return comparison;
}

}  // namespace armcal
