// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "armcal/core/progress.h"

namespace armcal {

/// What a choice of observations has to hold to.
struct ChoiceLimits {
  /// Least redundancy number of every chosen observation; 0: none.
  double least_redundancy = 0.0;
  /// Largest error of a single observation that may stay unfound or be blamed on another one, in
  /// the unit of `u`; infinite: no limit. See reliability.h.
  double largest_unnamed = 1e300;
};

struct ExchangeOptions {
  int observations = 0;
  ChoiceLimits limits;
  int starts = 8;  ///< random first choices; the best end counts
  std::uint64_t seed = 0;
  int threads = 1;  ///< never changes a digit
  Monitor monitor;
};

/// The best choice found.
struct ChosenObservations {
  std::vector<int> rows;  ///< ascending
  double log_determinant = 0.0;
  bool keeps_limits = false;
  double least_redundancy = 0.0;
  double largest_unnamed = 0.0;
};

/// Chooses, of many possible observations, those that determine all unknowns best: largest
/// determinant of the information matrix (D-optimal). From random starts observations are
/// exchanged against others one at a time as long as the determinant grows, by rank-one updates
/// (Fedorov 1972; Cook and Nachtsheim 1980). A choice that breaks the limits is then mended:
/// exchanges that bring the worst observation nearest to its limit. Every row is chosen at most
/// once. theory/complete_symmetric_point.md eq. (5)-(8).
/// @param design  one row per possible observation: its gradient over its uncertainty; full column
/// rank
/// @param u       uncertainty of each row, for the limit `largest_unnamed`
[[nodiscard]] ChosenObservations choose_observations(const Eigen::MatrixXd& design,
                                                     const Eigen::VectorXd& u,
                                                     const ExchangeOptions& options);

}  // namespace armcal
