// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace armcal {

/// Eight numbers that are computed on together (GCC vector extension). The compiler cuts a pack
/// into as many registers as the processor needs; every lane sees the same operations in the same
/// order, so the digits are the same on all.
using Pack = double __attribute__((vector_size(64)));
inline constexpr std::ptrdiff_t kLanes = 8;

// Functions marked so are compiled for several processors, and the best is taken at run time.
// Sanitizers and other compilers get the plain version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define ARMCAL_FOR_EVERY_PROCESSOR __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define ARMCAL_FOR_EVERY_PROCESSOR
#endif

}  // namespace armcal
