// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "armcal/numerics/least_squares_problem.h"

namespace armcal::testing {

/// A least-squares problem told as a whole, residuals and Jacobian, and cut into blocks as a test
/// likes.
class DenseProblem : public LeastSquaresProblem {
 public:
  struct Block {
    Eigen::Index rows = 0;
    std::vector<int> columns;  ///< the Jacobian is zero in the others
    Eigen::Index rows_per_observation = 1;
  };
  using Evaluate =
      std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd& J)>;

  DenseProblem(int unknowns, std::vector<Block> blocks, Evaluate evaluate)
      : unknowns_(unknowns), blocks_(std::move(blocks)), evaluate_(std::move(evaluate)) {
    for (const Block& block : blocks_) {
      firsts_.push_back(rows_);
      rows_ += block.rows;
    }
  }
  /// All in one block.
  DenseProblem(int unknowns, Eigen::Index rows, Evaluate evaluate)
      : DenseProblem(unknowns, {{rows, all(unknowns)}}, std::move(evaluate)) {}

  static std::vector<int> all(int unknowns) {
    std::vector<int> columns(static_cast<std::size_t>(unknowns));
    std::iota(columns.begin(), columns.end(), 0);
    return columns;
  }

  [[nodiscard]] int unknown_count() const override { return unknowns_; }
  [[nodiscard]] int block_count() const override { return static_cast<int>(blocks_.size()); }
  [[nodiscard]] BlockShape shape(int block) const override {
    const Block& b = blocks_[static_cast<std::size_t>(block)];
    return {b.rows, b.rows_per_observation, b.columns};
  }
  [[nodiscard]] std::unique_ptr<Evaluation> at(const Eigen::VectorXd& x) const override {
    auto here = std::make_unique<Here>(*this);
    here->residuals.resize(rows_);
    here->jacobian.resize(rows_, unknowns_);
    evaluate_(x, here->residuals, here->jacobian);
    return here;
  }

 private:
  struct Here : Evaluation {
    explicit Here(const DenseProblem& p) : problem(p) {}
    void fill(int block, const BlockRows& rows) const override {
      const auto& columns = problem.blocks_[static_cast<std::size_t>(block)].columns;
      const Eigen::Index first = problem.firsts_[static_cast<std::size_t>(block)];
      for (Eigen::Index r = 0; r < rows.rows; ++r) {
        double* row = rows.row(r);
        for (const int column : columns) *row++ = jacobian(first + r, column);
        rows.residual(r) = residuals(first + r);
      }
    }
    const DenseProblem& problem;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
  };

  int unknowns_;
  std::vector<Block> blocks_;
  Evaluate evaluate_;
  std::vector<Eigen::Index> firsts_;
  Eigen::Index rows_ = 0;
};

/// r = A x - b.
inline DenseProblem::Evaluate linear(Eigen::MatrixXd a, Eigen::VectorXd b) {
  return [a = std::move(a), b = std::move(b)](const Eigen::VectorXd& x, Eigen::VectorXd& r,
                                              Eigen::MatrixXd& J) {
    r = a * x - b;
    J = a;
  };
}

}  // namespace armcal::testing
