// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "armcal/core/parallel.h"
#include "armcal/numerics/gram_kernel.h"
#include "armcal/numerics/linear_algebra.h"

namespace armcal {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::size_t worker_count(const BlockPlan& plan, int threads) {
  return index(std::clamp(threads, 1, plan.shard_count()));
}

// Sums rows of equal columns in a small matrix of their own; adds it to the large one when the
// columns change.
class GramSink : public RowSink {
 public:
  GramSink(AlignedBuffer& local, Eigen::MatrixXd& gram) : local_(local), gram_(gram) {}

  void add(std::span<const int> columns, const BlockRows& rows) override {
    if (sums_ == nullptr || !std::ranges::equal(columns, columns_)) {
      scatter();
      columns_ = columns;
      stride_ = rows.stride;
      sums_ = local_.reserve(stride_ * stride_);
      std::fill_n(sums_, stride_ * stride_, 0.0);
    }
    add_gram(rows, sums_);
  }

  void scatter() {
    if (sums_ == nullptr) return;
    const auto count = static_cast<Eigen::Index>(columns_.size());
    const Eigen::Index residual = gram_.rows() - 1;
    for (Eigen::Index i = 0; i <= count; ++i) {
      const double* row = sums_ + i * stride_;
      double* column = gram_.col(i < count ? unknown(i) : residual).data();
      for (Eigen::Index j = i; j < count; ++j) column[unknown(j)] += row[j];
      column[residual] += row[count];
    }
  }

 private:
  [[nodiscard]] Eigen::Index unknown(Eigen::Index i) const {
    return columns_[static_cast<std::size_t>(i)];
  }

  AlignedBuffer& local_;
  Eigen::MatrixXd& gram_;
  std::span<const int> columns_;
  Eigen::Index stride_ = 0;
  double* sums_ = nullptr;
};

// Gathers rows below the R of those before and decomposes when there are enough.
class TriangularSink : public RowSink {
 public:
  // 8 (n + 1) rows below n + 1: the triangle on top costs an eighth more.
  explicit TriangularSink(Eigen::Index unknowns)
      : width_(unknowns + 1),
        stack_(Eigen::MatrixXd::Zero(width_ + std::max<Eigen::Index>(8 * width_, 64), width_)) {}

  void begin() {
    stack_.topRows(width_).setZero();
    filled_ = width_;
  }

  void add(std::span<const int> columns, const BlockRows& rows) override {
    for (Eigen::Index r = 0; r < rows.rows; ++r) {
      if (filled_ == stack_.rows()) reduce();
      stack_.row(filled_).setZero();
      const double* row = rows.row(r);
      for (const int column : columns) stack_(filled_, column) = *row++;
      stack_(filled_, width_ - 1) = *row;
      ++filled_;
    }
  }

  void add_triangle(const Eigen::MatrixXd& triangle) {
    if (filled_ + width_ > stack_.rows()) reduce();
    stack_.middleRows(filled_, width_) = triangle;
    filled_ += width_;
  }

  [[nodiscard]] Eigen::MatrixXd triangle() {
    reduce();
    return stack_.topRows(width_);
  }

 private:
  void reduce() {
    if (filled_ == width_) return;
    triangularise(stack_.topRows(filled_));
    filled_ = width_;
  }

  Eigen::Index width_;
  Eigen::MatrixXd stack_;
  Eigen::Index filled_ = 0;
};

}  // namespace

bool NormalEquations::finite() const {
  // An off-diagonal element is no larger than the diagonal ones that it belongs to.
  return std::isfinite(cost) && gram.diagonal().allFinite();
}

NormalEquationsBuilder::NormalEquationsBuilder(const LeastSquaresProblem& problem,
                                               const BlockPlan& plan, const PassOptions& options)
    : problem_(problem),
      plan_(plan),
      options_(options),
      shards_(index(plan.shard_count())),
      workers_(worker_count(plan, options.threads)) {}

void NormalEquationsBuilder::build(const Eigen::VectorXd& x, NormalEquations& equations) {
  const auto evaluation = problem_.at(x);
  const Eigen::Index size = plan_.unknowns + 1;
  // With one shard there is nothing to put together: it is summed where the result is wanted.
  const bool single = plan_.shard_count() == 1;
  const auto sum_shard = [&](int shard, int worker) {
    Worker& work = workers_[index(worker)];
    NormalEquations& sums = single ? equations : shards_[index(shard)];
    sums.gram.setZero(size, size);
    GramSink sink(work.local, sums.gram);
    sums.cost = sweep_shard(problem_, *evaluation, plan_, shard, options_.loss,
                            options_.monitor.stop, work.rows, sink);
    sink.scatter();
  };
  parallel_for(plan_.shard_count(), static_cast<int>(workers_.size()), sum_shard);
  if (!single) {
    equations.gram.setZero(size, size);
    equations.cost = 0.0;
    for (const NormalEquations& shard : shards_) {
      equations.gram += shard.gram;
      equations.cost += shard.cost;
    }
  }
  if (options_.loss.kind == RobustLoss::none) {
    equations.cost = equations.gram(size - 1, size - 1);
  }
}

TriangularSystem triangular_system(const LeastSquaresProblem& problem, const BlockPlan& plan,
                                   const Eigen::VectorXd& x, const PassOptions& options) {
  const auto evaluation = problem.at(x);
  const Eigen::Index n = plan.unknowns;
  const std::size_t workers = worker_count(plan, options.threads);
  std::vector<AlignedBuffer> rows(workers);
  std::vector<TriangularSink> sinks(workers, TriangularSink(n));
  std::vector<Eigen::MatrixXd> triangles(index(plan.shard_count()));
  const auto reduce_shard = [&](int shard, int worker) {
    TriangularSink& sink = sinks[index(worker)];
    sink.begin();
    sweep_shard(problem, *evaluation, plan, shard, options.loss, options.monitor.stop,
                rows[index(worker)], sink);
    triangles[index(shard)] = sink.triangle();
  };
  parallel_for(plan.shard_count(), static_cast<int>(workers), reduce_shard);
  TriangularSink& sink = sinks.front();
  if (triangles.size() > 1) {
    sink.begin();
    for (const Eigen::MatrixXd& triangle : triangles) sink.add_triangle(triangle);
    triangles.front() = sink.triangle();
  }
  return {triangles.front().topLeftCorner(n, n), triangles.front().col(n).head(n)};
}

}  // namespace armcal
