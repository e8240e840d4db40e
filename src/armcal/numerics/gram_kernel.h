// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/numerics/least_squares_problem.h"

namespace armcal {

/// How many doubles one instruction takes. The digits of a result never depend on it.
enum class VectorWidth { two = 2, four = 4, eight = 8 };

/// The widest that this processor has.
[[nodiscard]] VectorWidth widest_vectors();

/// Adds the Gram matrix of the rows, residual included, to `gram`: theory/least_squares.md eq.
/// (11). Rows are added one after the other, products and sums rounded singly, so neither the
/// processor nor the cutting of rows into blocks changes a digit.
/// @param gram  row-major, stride x stride, aligned to 64 bytes; only its elements (i, j), i <= j,
///              mean anything afterwards
void add_gram(const BlockRows& rows, double* gram, VectorWidth width = widest_vectors());

}  // namespace armcal
