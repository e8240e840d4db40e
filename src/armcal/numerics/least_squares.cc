// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/numerics/normal_equations.h"
#include "armcal/numerics/step_model.h"

namespace armcal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A share of the cost that not even its last digit shows.
constexpr double kNothing = 1e-17;
// Gain, as a share of the predicted one, from which a step is taken.
constexpr double kLeastGain = 1e-4;
// Moré's 1/4 instead of 1/10 costs half as many steps again on NIST's far starts.
constexpr double kPoorGain = 0.1;
constexpr double kGoodGain = 0.75;

// A point that has been accepted, with what is known there.
class Iteration {
 public:
  Iteration(const LeastSquaresProblem& problem, const LeastSquaresOptions& options)
      : problem_(problem),
        options_(options),
        plan_(plan_blocks(problem)),
        pass_{{options.loss, options.loss_scale}, options.threads, options.monitor},
        builder_(problem, plan_, pass_) {}

  LeastSquaresSolution run(const Eigen::VectorXd& start);

 private:
  void enter();
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] bool blind(const ModelStep& step) const;
  [[nodiscard]] Eigen::VectorXd moved(const ModelStep& step) const;
  void adapt_radius(const ModelStep& step, double gain);
  void take(Eigen::VectorXd x);
  LeastSquaresSolution ended(Termination termination);

  const LeastSquaresProblem& problem_;
  const LeastSquaresOptions& options_;
  BlockPlan plan_;
  PassOptions pass_;
  NormalEquationsBuilder builder_;

  NormalEquations here_;
  NormalEquations there_;
  std::optional<StepModel> model_;
  Eigen::VectorXd longest_columns_;
  // None until a step has failed: most problems start where Gauss-Newton needs no help.
  double radius_ = kInfinity;
  double damping_ = 0.0;
  double last_decrease_ = kInfinity;
  LeastSquaresSolution solution_;
};

LeastSquaresSolution Iteration::run(const Eigen::VectorXd& start) {
  solution_.x = start;
  solution_.rows = plan_.rows;
  options_.monitor.report("adjusting", 0.0);
  builder_.build(start, here_);
  solution_.cost = here_.cost;
  if (!here_.finite()) return ended(Termination::not_finite);
  solution_.costs.push_back(solution_.cost);
  enter();
  while (true) {
    if (at_rest()) {
      solution_.x = moved(model_->undamped());
      solution_.cost = std::max(0.0, solution_.cost - model_->undamped().predicted_decrease);
      solution_.costs.push_back(solution_.cost);
      ++solution_.iterations;
      return ended(Termination::converged);
    }
    if (solution_.iterations >= options_.max_iterations) {
      return ended(Termination::iteration_limit);
    }
    ++solution_.iterations;
    options_.monitor.report("adjusting", static_cast<double>(solution_.iterations) /
                                             static_cast<double>(options_.max_iterations));
    const ModelStep step = model_->step_within(radius_, damping_);
    if (blind(step) && step.predicted_decrease >= last_decrease_) {
      return ended(Termination::converged);
    }
    if (!(step.predicted_decrease > kNothing * here_.cost)) {
      return ended(Termination::no_decrease);
    }
    Eigen::VectorXd x = moved(step);
    builder_.build(x, there_);
    const bool usable = there_.finite();
    const double gain = usable ? (here_.cost - there_.cost) / step.predicted_decrease : -kInfinity;
    const bool unasked = usable && blind(step);
    if (!unasked) adapt_radius(step, gain);
    if (!unasked && !(gain > kLeastGain)) continue;
    last_decrease_ = blind(step) ? step.predicted_decrease : kInfinity;
    take(std::move(x));
  }
}

// Prepares for steps from the point that here_ belongs to.
void Iteration::enter() {
  const auto triangular = [this] { return triangular_system(problem_, plan_, solution_.x, pass_); };
  model_.emplace(here_, triangular);
  if (longest_columns_.size() == 0) longest_columns_ = model_->scales();
  longest_columns_ = longest_columns_.cwiseMax(model_->scales());
  model_->weigh_lengths(longest_columns_.cwiseQuotient(model_->scales()));
}

bool Iteration::at_rest() const {
  const auto n = static_cast<double>(plan_.unknowns);
  const double resolution = options_.residual_resolution;
  return model_->undamped().predicted_decrease <=
         std::max(options_.relative_decrease * here_.cost, n * resolution * resolution);
}

// Whether the cost cannot tell the step from none.
bool Iteration::blind(const ModelStep& step) const {
  if (step.damping > 0.0) return false;
  const double resolution = options_.residual_resolution;
  const double root = std::sqrt(here_.cost) + resolution;
  const double visible = kSumRounding * here_.cost +
                         4.0 * root * resolution * std::sqrt(static_cast<double>(plan_.rows));
  return step.predicted_decrease <= visible;
}

Eigen::VectorXd Iteration::moved(const ModelStep& step) const {
  return problem_.moved(solution_.x, step.scaled.cwiseQuotient(model_->scales()));
}

void Iteration::adapt_radius(const ModelStep& step, double gain) {
  if (gain <= kPoorGain) {
    // Moré takes the lowest point of a parabola, 1 / (2 - gain): tried, and two of NIST's far
    // starts needed more than a thousand steps.
    const double share = 0.5 / (1.0 - std::min(gain, 0.0));
    radius_ = std::clamp(share, 0.1, 0.5) * std::min(radius_, 10.0 * step.length);
  } else if (gain >= kGoodGain || step.damping == 0.0) {
    radius_ = 2.0 * step.length;
  }
  damping_ = step.damping;
}

void Iteration::take(Eigen::VectorXd x) {
  solution_.x = std::move(x);
  std::swap(here_, there_);
  solution_.cost = here_.cost;
  solution_.costs.push_back(solution_.cost);
  enter();
}

LeastSquaresSolution Iteration::ended(Termination termination) {
  solution_.termination = termination;
  if (termination == Termination::not_finite) return std::move(solution_);
  solution_.condition_number = model_->condition_number();
  // Rounding alone keeps a fit with too many unknowns, exact as it is, from looking at rest.
  if (termination == Termination::no_decrease && !model_->full_rank()) {
    solution_.termination = Termination::rank_deficient;
  }
  if (termination != Termination::converged) return std::move(solution_);
  auto factor = model_->inverse_factor();
  if (factor) {
    solution_.inverse_factor = *std::move(factor);
  } else {
    solution_.termination = Termination::rank_deficient;
  }
  return std::move(solution_);
}

}  // namespace

std::string_view to_string(Termination termination) {
  switch (termination) {
    case Termination::converged:
      return "converged";
    case Termination::iteration_limit:
      return "iteration limit";
    case Termination::no_decrease:
      return "no decrease";
    case Termination::rank_deficient:
      return "rank deficient";
    case Termination::not_finite:
      return "not finite";
  }
  return "";
}

LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem,
                                         const Eigen::VectorXd& start,
                                         const LeastSquaresOptions& options) {
  return Iteration(problem, options).run(start);
}

Eigen::MatrixXd triangular_factor(const LeastSquaresProblem& problem, const Eigen::VectorXd& x,
                                  const Monitor& monitor, int threads) {
  const PassOptions pass{{}, threads, monitor};
  return triangular_system(problem, plan_blocks(problem), x, pass).r;
}

Eigen::VectorXd residuals_at(const LeastSquaresProblem& problem, const Eigen::VectorXd& x) {
  class ResidualSink : public RowSink {
   public:
    explicit ResidualSink(Eigen::Index rows) : residuals(rows) {}
    void add(std::span<const int> /*columns*/, const BlockRows& rows) override {
      for (Eigen::Index r = 0; r < rows.rows; ++r) residuals(filled_++) = rows.residual(r);
    }
    Eigen::VectorXd residuals;

   private:
    Eigen::Index filled_ = 0;
  };
  const BlockPlan plan = plan_blocks(problem);
  const auto evaluation = problem.at(x);
  ResidualSink sink(plan.rows);
  AlignedBuffer workspace;
  for (int shard = 0; shard < plan.shard_count(); ++shard) {
    sweep_shard(problem, *evaluation, plan, shard, {}, {}, workspace, sink);
  }
  return std::move(sink.residuals);
}

}  // namespace armcal
