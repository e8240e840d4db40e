// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "armcal/identification/residuals/residual.h"
#include "armcal/identification/unknowns.h"
#include "armcal/numerics/least_squares.h"

namespace armcal {

/// What is known of an unknown before the readings: one more observation, x = mean within u.
struct Prior {
  int unknown = 0;  ///< place among the unknowns
  double mean = 0.0;
  double u = 1.0;  ///< mm or rad
};

/// The residuals of an identification as a least-squares problem: rows divided by their
/// uncertainties, priors last. theory/identification.md eq. (1)
class EstimationProblem : public LeastSquaresProblem {
 public:
  /// @param residuals  must outlive the problem, as must `unknowns`
  /// @param held       places among the unknowns that stay as they are
  EstimationProblem(const std::vector<const Residual*>& residuals, const Unknowns& unknowns,
                    std::vector<Prior> priors, const std::vector<int>& held = {});

  [[nodiscard]] int unknown_count() const override { return static_cast<int>(active_.size()); }
  [[nodiscard]] int block_count() const override { return static_cast<int>(blocks_.size()); }
  [[nodiscard]] BlockShape shape(int block) const override;
  [[nodiscard]] std::unique_ptr<Evaluation> at(const Eigen::VectorXd& x) const override;
  [[nodiscard]] Eigen::VectorXd moved(const Eigen::VectorXd& x,
                                      const Eigen::VectorXd& step) const override;

  /// What rounding does to a residual: coordinates as large as the arm and what it is measured
  /// against, in units of the finest uncertainty. For LeastSquaresOptions::residual_resolution.
  [[nodiscard]] double residual_resolution() const;

  /// Places, among all unknowns, of those that move.
  [[nodiscard]] const std::vector<int>& active() const { return active_; }

  /// Where the rows of a block come from: observations first .. of a residual; nothing for priors.
  struct Block {
    const Residual* residual = nullptr;
    Eigen::Index first = 0;
    Eigen::Index count = 0;
    std::size_t layout = 0;  // of its columns
  };
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }

 private:
  class At;
  // The columns that residuals of one kind of dependence share.
  struct Layout {
    std::vector<int> columns;  // active columns, ascending
    std::vector<int> filled;   // for each: its place among the columns that the residual fills
    Eigen::Index filled_count = 0;
    bool in_place = false;  // the residual fills just these
  };
  [[nodiscard]] std::size_t layout_of(const Residual& residual);

  const Unknowns& unknowns_;
  std::vector<Prior> priors_;
  std::vector<int> active_;
  std::vector<int> place_of_unknown_;  // among the active ones, or -1
  std::vector<Layout> layouts_;
  std::vector<Block> blocks_;
};

}  // namespace armcal
