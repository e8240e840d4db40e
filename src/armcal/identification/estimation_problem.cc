// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/estimation_problem.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace armcal {

class EstimationProblem::At : public LeastSquaresProblem::Evaluation {
 public:
  At(const EstimationProblem& problem, const Eigen::VectorXd& x)
      : problem_(problem), x_(x), arm_(at_arm(problem.unknowns_, x)) {}

  void fill(int index, const BlockRows& rows) const override {
    const Block& block = problem_.blocks_[static_cast<std::size_t>(index)];
    if (block.residual == nullptr) {
      fill_priors(rows);
      return;
    }
    const Layout& layout = problem_.layouts_[block.layout];
    if (layout.in_place) {
      block.residual->fill(arm_, problem_.unknowns_, x_, block.first, block.count, rows);
    } else {
      fill_and_pick(block, layout, rows);
    }
    block.residual->whiten(block.first, block.count, rows);
  }

 private:
  static ArmAt at_arm(const Unknowns& unknowns, const Eigen::VectorXd& x) {
    ArmModel arm = unknowns.arm_at(x);
    TipRows tips(arm, unknowns.columns());
    return {std::move(arm), std::move(tips)};
  }

  // Some of what the residual depends on is held, or its columns stand in another order.
  void fill_and_pick(const Block& block, const Layout& layout, const BlockRows& rows) const {
    const Eigen::Index stride = layout.filled_count + 1;
    std::vector<double> data(static_cast<std::size_t>(rows.rows * stride), 0.0);
    const BlockRows all{rows.rows, layout.filled_count, stride, data.data()};
    block.residual->fill(arm_, problem_.unknowns_, x_, block.first, block.count, all);
    for (Eigen::Index r = 0; r < rows.rows; ++r) {
      for (std::size_t c = 0; c < layout.filled.size(); ++c)
        rows.row(r)[c] = all.row(r)[layout.filled[c]];
      rows.residual(r) = all.residual(r);
    }
  }

  void fill_priors(const BlockRows& rows) const {
    for (std::size_t i = 0; i < problem_.priors_.size(); ++i) {
      const Prior& prior = problem_.priors_[i];
      double* const row = rows.row(static_cast<Eigen::Index>(i));
      const auto& columns = problem_.layouts_.back().columns;
      const int place = problem_.place_of_unknown_[static_cast<std::size_t>(prior.unknown)];
      row[std::lower_bound(columns.begin(), columns.end(), place) - columns.begin()] =
          1.0 / prior.u;
      row[rows.columns] = (x_(prior.unknown) - prior.mean) / prior.u;
    }
  }

  const EstimationProblem& problem_;
  const Eigen::VectorXd x_;
  const ArmAt arm_;
};

EstimationProblem::EstimationProblem(const std::vector<const Residual*>& residuals,
                                     const Unknowns& unknowns, std::vector<Prior> priors,
                                     const std::vector<int>& held)
    : unknowns_(unknowns), priors_(std::move(priors)) {
  place_of_unknown_.assign(static_cast<std::size_t>(unknowns.step_size()), -1);
  for (int i = 0; i < unknowns.step_size(); ++i) {
    if (std::find(held.begin(), held.end(), i) != held.end()) continue;
    place_of_unknown_[static_cast<std::size_t>(i)] = static_cast<int>(active_.size());
    active_.push_back(i);
  }
  for (const Residual* residual : residuals) {
    const std::size_t layout = layout_of(*residual);
    for (Eigen::Index first = 0; first < residual->count(); first += kObservationsPerBlock) {
      blocks_.push_back(
          {residual, first, std::min(kObservationsPerBlock, residual->count() - first), layout});
    }
  }
  std::erase_if(priors_, [&](const Prior& prior) {
    return place_of_unknown_[static_cast<std::size_t>(prior.unknown)] < 0;
  });
  if (priors_.empty()) return;
  Layout layout;
  for (const Prior& prior : priors_) {
    layout.columns.push_back(place_of_unknown_[static_cast<std::size_t>(prior.unknown)]);
  }
  std::sort(layout.columns.begin(), layout.columns.end());
  layouts_.push_back(std::move(layout));
  blocks_.push_back({nullptr, 0, static_cast<Eigen::Index>(priors_.size()), layouts_.size() - 1});
}

std::size_t EstimationProblem::layout_of(const Residual& residual) {
  // Places of what the residual fills, in its order.
  std::vector<int> filled;
  if (residual.depends_on_arm()) {
    filled.resize(static_cast<std::size_t>(unknowns_.arm_size()));
    std::iota(filled.begin(), filled.end(), 0);
  }
  for (const int id : residual.nuisances()) {
    const Nuisance& nuisance = unknowns_[id];
    const auto size = static_cast<int>(step_names(nuisance).size());
    for (int i = 0; i < size; ++i) filled.push_back(static_cast<int>(nuisance.step) + i);
  }
  Layout layout;
  layout.filled_count = static_cast<Eigen::Index>(filled.size());
  std::vector<std::pair<int, int>> picked;  // active column, place among the filled
  for (std::size_t i = 0; i < filled.size(); ++i) {
    const int place = place_of_unknown_[static_cast<std::size_t>(filled[i])];
    if (place >= 0) picked.emplace_back(place, static_cast<int>(i));
  }
  layout.in_place = picked.size() == filled.size() && std::is_sorted(picked.begin(), picked.end());
  std::sort(picked.begin(), picked.end());
  for (const auto& [column, place] : picked) {
    layout.columns.push_back(column);
    layout.filled.push_back(place);
  }
  const auto same = std::find_if(layouts_.begin(), layouts_.end(), [&](const Layout& each) {
    return each.columns == layout.columns && each.filled == layout.filled &&
           each.filled_count == layout.filled_count;
  });
  if (same != layouts_.end()) return static_cast<std::size_t>(same - layouts_.begin());
  layouts_.push_back(std::move(layout));
  return layouts_.size() - 1;
}

double EstimationProblem::residual_resolution() const {
  // A coordinate is a sum of tens of rounded products, whose errors partly cancel.
  constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
  const ArmModel& arm = unknowns_.nominal();
  const double reach = reach_mm(arm) + arm.base_from_first_joint.translation_mm.norm();
  double resolution = 0.0;
  for (const Block& block : blocks_) {
    if (block.residual == nullptr) continue;
    const Eigen::Matrix3Xd& reference_mm = block.residual->group().reference_mm;
    for (Eigen::Index i = block.first; i < block.first + block.count; ++i) {
      const double away =
          reference_mm.cols() > 0 ? reference_mm.col(block.residual->row(i)).norm() : 0.0;
      resolution =
          std::max(resolution, kRounding * (reach + away) * block.residual->largest_weight(i));
    }
  }
  return resolution;
}

LeastSquaresProblem::BlockShape EstimationProblem::shape(int index) const {
  const Block& block = blocks_[static_cast<std::size_t>(index)];
  const Eigen::Index per_observation =
      block.residual == nullptr ? 1 : block.residual->rows_per_observation();
  return {.rows = block.count * per_observation,
          .rows_per_observation = per_observation,
          .columns = layouts_[block.layout].columns};
}

std::unique_ptr<LeastSquaresProblem::Evaluation> EstimationProblem::at(
    const Eigen::VectorXd& x) const {
  return std::make_unique<At>(*this, x);
}

Eigen::VectorXd EstimationProblem::moved(const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& step) const {
  Eigen::VectorXd whole = Eigen::VectorXd::Zero(unknowns_.step_size());
  for (std::size_t i = 0; i < active_.size(); ++i) {
    whole(active_[i]) = step(static_cast<Eigen::Index>(i));
  }
  return unknowns_.moved(x, whole);
}

}  // namespace armcal
