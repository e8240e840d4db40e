// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/gram_kernel.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "armcal/core/random.h"
#include "armcal/numerics/block_sweep.h"

namespace armcal {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Rows with random derivatives and residual, zeros up to the stride.
class Rows {
 public:
  Rows(Eigen::Index count, Eigen::Index columns, std::uint64_t seed) {
    rows_ = {count, columns, row_stride(columns), nullptr};
    rows_.data = buffer_.reserve(count * rows_.stride);
    RandomStream random(seed);
    for (Eigen::Index r = 0; r < count; ++r) {
      for (Eigen::Index c = 0; c < rows_.stride; ++c) {
        rows_.row(r)[c] = c <= columns ? random.normal() : 0.0;
      }
    }
  }
  [[nodiscard]] const BlockRows& rows() const { return rows_; }
  [[nodiscard]] RowMajor matrix() const {
    return Eigen::Map<const RowMajor>(rows_.data, rows_.rows, rows_.stride)
        .leftCols(rows_.columns + 1);
  }

 private:
  AlignedBuffer buffer_;
  BlockRows rows_;
};

std::vector<VectorWidth> widths() {
  std::vector<VectorWidth> available = {VectorWidth::two};
  if (widest_vectors() != VectorWidth::two) available.push_back(VectorWidth::four);
  if (widest_vectors() == VectorWidth::eight) available.push_back(VectorWidth::eight);
  return available;
}

RowMajor upper(const double* gram, const BlockRows& rows) {
  return Eigen::Map<const RowMajor>(gram, rows.stride, rows.stride)
      .topLeftCorner(rows.columns + 1, rows.columns + 1)
      .triangularView<Eigen::Upper>();
}

RowMajor gram_of(std::initializer_list<BlockRows> pieces, VectorWidth width) {
  const BlockRows& rows = *pieces.begin();
  AlignedBuffer buffer;
  double* gram = buffer.reserve(rows.stride * rows.stride);
  std::fill_n(gram, rows.stride * rows.stride, 0.0);
  for (const BlockRows& piece : pieces) add_gram(piece, gram, width);
  return upper(gram, rows);
}

TEST(GramKernel, AgreesWithTheMatrixProductForEveryNumberOfColumns) {
  for (Eigen::Index columns = 1; columns <= 70; ++columns) {
    const Rows rows(columns + 37, columns, static_cast<std::uint64_t>(columns));
    const RowMajor a = rows.matrix();
    const RowMajor expected = (a.transpose() * a).triangularView<Eigen::Upper>();
    const RowMajor gram = gram_of({rows.rows()}, widest_vectors());
    // Sums of about a hundred products of order one.
    ASSERT_LT((gram - expected).cwiseAbs().maxCoeff(), 1e-12) << columns;
  }
}

TEST(GramKernel, HasTheSameDigitsForVectorsOfEveryWidth) {
  for (Eigen::Index columns = 0; columns <= 70; ++columns) {
    const Rows rows(50, columns, 7);
    const RowMajor expected = gram_of({rows.rows()}, VectorWidth::two);
    for (const VectorWidth width : widths()) {
      ASSERT_EQ(gram_of({rows.rows()}, width), expected) << columns;
    }
  }
}

TEST(GramKernel, HasTheSameDigitsHoweverTheRowsAreCut) {
  const Rows rows(500, 33, 8);
  BlockRows first = rows.rows();
  BlockRows second = rows.rows();
  first.rows = 123;
  second.rows = 500 - 123;
  second.data = rows.rows().row(123);
  EXPECT_EQ(gram_of({first, second}, widest_vectors()), gram_of({rows.rows()}, widest_vectors()));
}

TEST(GramKernel, AddsNothingForNoRows) {
  const Rows rows(0, 5, 9);
  EXPECT_TRUE(gram_of({rows.rows()}, widest_vectors()).isZero(0.0));
}

}  // namespace
}  // namespace armcal
