// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace armcal {

/// A column that the others already explain: column = sum of weights * basis columns.
struct DependentColumn {
  int column = 0;
  /// Weight of every basis column, in the order of RankAnalysis::basis, in the units of the
  /// Jacobian as given. A unit change of this unknown moves the data exactly like these changes of
  /// the basis unknowns.
  Eigen::VectorXd weights;
};

/// What a Jacobian can and cannot tell apart.
struct RankAnalysis {
  int rank = 0;
  std::vector<int> basis;                  ///< columns that are kept, in order of preference
  std::vector<DependentColumn> dependent;  ///< columns explained by the basis
  std::vector<int> unseen;                 ///< columns that are zero: no datum depends on them
  double condition_number = 1.0;           ///< of the kept columns, each scaled to unit length
  Eigen::VectorXd singular_values;         ///< of the same
};

/// Chooses, of the columns of `jacobian`, a largest independent set, taking them in the order of
/// `preference` (most wanted first) - so which of several equivalent unknowns is held is a stated
/// choice and not an accident of rounding. Columns are scaled to unit length first (mm and rad
/// mix). Method: theory/least_squares.md eq. (8)-(10), orthogonalisation with a second pass.
/// @param preference  a permutation of the columns
/// @param tolerance   a column counts as explained when less than this share of its length sticks
/// out
[[nodiscard]] RankAnalysis analyse_rank(const Eigen::MatrixXd& jacobian,
                                        const std::vector<int>& preference,
                                        double tolerance = 1e-9);

}  // namespace armcal
