// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace armcal {

/// A reproducible stream of random numbers, one of 2^64 under each seed.
///
/// Counter-based (Philox4x32-10: Salmon, Moraes, Dror, Shaw, SC'11; Random123): number k of stream
/// s is a pure function of (seed, s, k). So trial s of a simulation draws the same numbers whatever
/// thread runs it and in whatever order. Normal deviates come from the inverse distribution
/// function, one uniform each, so they are the same on every platform to the last digits of `log`
/// and `sqrt`.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0);

  /// Uniform on the open interval (0, 1), 53 bits.
  [[nodiscard]] double uniform();
  /// Uniform on (low, high).
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Normal with mean 0 and standard deviation 1.
  [[nodiscard]] double normal();
  /// Uniform integer in [0, count). @param count at least 1
  [[nodiscard]] std::uint64_t below(std::uint64_t count);
  /// 64 random bits.
  [[nodiscard]] std::uint64_t bits();

 private:
  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t block_ = 0;
  std::array<std::uint64_t, 2> ready_{};
  int ready_count_ = 0;
};

/// Standard normal deviate whose distribution function is `probability` in (0, 1).
/// Wichura, Algorithm AS 241 (PPND16), Applied Statistics 37 (1988) 477-484; relative accuracy
/// 1e-16.
[[nodiscard]] double normal_deviate(double probability);

}  // namespace armcal
