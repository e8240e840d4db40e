// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/numerics/gram_kernel.h"

#include <algorithm>
#include <cstddef>

// One macro decides whether there are variants for wider vectors than every processor of the
// architecture has.
#if defined(__x86_64__) && defined(__GNUC__)
#define ARMCAL_WIDE_VECTORS 1
#else
#define ARMCAL_WIDE_VECTORS 0
#endif

namespace armcal {
namespace {

// Vector types are spelled to the width that the instructions of their function have: GCC 12 keeps
// wider ones in memory, twenty times slower (docs/decisions/vector-kernels.md).
using Pack2 [[gnu::vector_size(16), gnu::may_alias]] = double;

constexpr Eigen::Index kTileRows = 4;
// Rows that pass through all tiles together: 16 KiB, so that they stay in the first-level cache.
constexpr Eigen::Index kChunkDoubles = 2048;

// kTileRows x (kPacks * lanes) elements of the Gram matrix, kept in registers over all rows.
template <class Pack, int kPacks>
[[gnu::always_inline]] inline void add_tile(const double* row, Eigen::Index count,
                                            Eigen::Index stride, Eigen::Index i, Eigen::Index j,
                                            double* tile) {
  constexpr auto kLanes = static_cast<Eigen::Index>(sizeof(Pack) / sizeof(double));
  Pack sums[std::size_t{kTileRows}][std::size_t{kPacks}];
#pragma GCC unroll 4
  for (int a = 0; a < kTileRows; ++a) {
#pragma GCC unroll 2
    for (int p = 0; p < kPacks; ++p) {
      sums[a][p] = *reinterpret_cast<const Pack*>(tile + a * stride + p * kLanes);
    }
  }
  for (Eigen::Index r = 0; r < count; ++r, row += stride) {
#pragma GCC unroll 2
    for (int p = 0; p < kPacks; ++p) {
      const Pack right = *reinterpret_cast<const Pack*>(row + j + p * kLanes);
#pragma GCC unroll 4
      for (int a = 0; a < kTileRows; ++a) sums[a][p] += row[i + a] * right;
    }
  }
#pragma GCC unroll 4
  for (int a = 0; a < kTileRows; ++a) {
#pragma GCC unroll 2
    for (int p = 0; p < kPacks; ++p) {
      *reinterpret_cast<Pack*>(tile + a * stride + p * kLanes) = sums[a][p];
    }
  }
}

template <class Pack, int kPacks>
[[gnu::always_inline]] inline void add_tiles(const BlockRows& rows, double* gram) {
  constexpr auto kTileColumns = static_cast<Eigen::Index>(kPacks * sizeof(Pack) / sizeof(double));
  const Eigen::Index width = rows.columns + 1;
  const Eigen::Index chunk = std::max<Eigen::Index>(16, kChunkDoubles / rows.stride);
  for (Eigen::Index first = 0; first < rows.rows; first += chunk) {
    const Eigen::Index count = std::min(chunk, rows.rows - first);
    for (Eigen::Index i = 0; i < width; i += kTileRows) {
      // From the tile that holds the diagonal.
      for (Eigen::Index j = i - i % kTileColumns; j < width; j += kTileColumns) {
        add_tile<Pack, kPacks>(rows.row(first), count, rows.stride, i, j,
                               gram + i * rows.stride + j);
      }
    }
  }
}

void add_by_two(const BlockRows& rows, double* gram) { add_tiles<Pack2, 2>(rows, gram); }

#if ARMCAL_WIDE_VECTORS
using Pack4 [[gnu::vector_size(32), gnu::may_alias]] = double;
using Pack8 [[gnu::vector_size(64), gnu::may_alias]] = double;

[[gnu::target("avx2")]] void add_by_four(const BlockRows& rows, double* gram) {
  add_tiles<Pack4, 2>(rows, gram);
}
[[gnu::target("avx512f")]] void add_by_eight(const BlockRows& rows, double* gram) {
  add_tiles<Pack8, 1>(rows, gram);
}
#endif

}  // namespace

VectorWidth widest_vectors() {
#if ARMCAL_WIDE_VECTORS
  if (__builtin_cpu_supports("avx512f") != 0) return VectorWidth::eight;
  if (__builtin_cpu_supports("avx2") != 0) return VectorWidth::four;
#endif
  return VectorWidth::two;
}

void add_gram(const BlockRows& rows, double* gram, VectorWidth width) {
#if ARMCAL_WIDE_VECTORS
  if (width == VectorWidth::eight) return add_by_eight(rows, gram);
  if (width == VectorWidth::four) return add_by_four(rows, gram);
#else
  static_cast<void>(width);
#endif
  add_by_two(rows, gram);
}

}  // namespace armcal
