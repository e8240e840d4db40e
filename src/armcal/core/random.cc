// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/random.h"

#include <Random123/philox.h>

#include <cmath>

#include "armcal/core/invariant.h"

namespace armcal {
namespace {

// Horner form, highest power first.
template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double x) {
  double sum = 0.0;
  for (const double c : coefficients) sum = sum * x + c;
  return sum;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : seed_(seed), stream_(stream) {}

std::uint64_t RandomStream::bits() {
  if (ready_count_ == 0) {
    const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
    const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); };
    const r123::Philox4x32::ctr_type counter = {
        {low(block_), high(block_), low(stream_), high(stream_)}};
    const r123::Philox4x32::key_type key = {{low(seed_), high(seed_)}};
    const auto words = r123::Philox4x32()(counter, key);
    const auto join = [](std::uint32_t a, std::uint32_t b) { return (std::uint64_t{b} << 32) | a; };
    ready_ = {join(words[2], words[3]), join(words[0], words[1])};
    ready_count_ = 2;
    ++block_;
  }
  return ready_[static_cast<std::size_t>(--ready_count_)];
}

double RandomStream::uniform() {
  // 53 random bits and a half: never 0, never 1.
  return (static_cast<double>(bits() >> 11) + 0.5) * 0x1.0p-53;
}

double RandomStream::normal() { return normal_deviate(uniform()); }

std::uint64_t RandomStream::below(std::uint64_t count) {
  ARMCAL_INVARIANT(count > 0);
  // Draws from the incomplete last run of values are thrown away, so that every value is equally
  // likely.
  const std::uint64_t limit = count * (UINT64_MAX / count);
  std::uint64_t draw = bits();
  while (draw >= limit) draw = bits();
  return draw % count;
}

double normal_deviate(double probability) {
  const double q = probability - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q *
           polynomial<8>({2.5090809287301226727e3, 3.3430575583588128105e4, 6.7265770927008700853e4,
                          4.5921953931549871457e4, 1.3731693765509461125e4, 1.9715909503065514427e3,
                          1.3314166789178437745e2, 3.3871328727963666080e0},
                         r) /
           polynomial<8>({5.2264952788528545610e3, 2.8729085735721942674e4, 3.9307895800092710610e4,
                          2.1213794301586595867e4, 5.3941960214247511077e3, 6.8718700749205790830e2,
                          4.2313330701600911252e1, 1.0},
                         r);
  }
  const double tail = q < 0.0 ? probability : 1.0 - probability;
  double r = std::sqrt(-std::log(tail));
  double deviate = 0.0;
  if (r <= 5.0) {
    r -= 1.6;
    deviate = polynomial<8>(
                  {7.74545014278341407640e-4, 2.27238449892691845833e-2, 2.41780725177450611770e-1,
                   1.27045825245236838258e0, 3.64784832476320460504e0, 5.76949722146069140550e0,
                   4.63033784615654529590e0, 1.42343711074968357734e0},
                  r) /
              polynomial<8>(
                  {1.05075007164441684324e-9, 5.47593808499534494600e-4, 1.51986665636164571966e-2,
                   1.48103976427480074590e-1, 6.89767334985100004550e-1, 1.67638483018380384940e0,
                   2.05319162663775882187e0, 1.0},
                  r);
  } else {
    r -= 5.0;
    deviate = polynomial<8>(
                  {2.01033439929228813265e-7, 2.71155556874348757815e-5, 1.24266094738807843860e-3,
                   2.65321895265761230930e-2, 2.96560571828504891230e-1, 1.78482653991729133580e0,
                   5.46378491116411436990e0, 6.65790464350110377720e0},
                  r) /
              polynomial<8>(
                  {2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5,
                   7.86869131145613259100e-4, 1.48753612908506148525e-2, 1.36929880922735805310e-1,
                   5.99832206555887937690e-1, 1.0},
                  r);
  }
  return q < 0.0 ? -deviate : deviate;
}

}  // namespace armcal
