// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/maximum_permissible_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armcal/core/units.h"

namespace armcal {
namespace {

std::string micrometres(double mm) {
  return fmt::format("{:.6g} um", micrometres_from_millimetres(mm));
}

void check_line(double a_mm, double k) {
  if (!(std::isfinite(a_mm) && a_mm >= 0.0)) {
    throw std::invalid_argument(fmt::format("limit A + L/K: A = {} mm must not be negative", a_mm));
  }
  if (!(std::isfinite(k) && k > 0.0)) {
    throw std::invalid_argument(fmt::format("limit A + L/K: K = {} must be larger than 0", k));
  }
}

}  // namespace

MaximumPermissibleError MaximumPermissibleError::constant(double a_mm) {
  if (!(std::isfinite(a_mm) && a_mm > 0.0)) {
    throw std::invalid_argument(fmt::format("limit {} mm: must be larger than 0", a_mm));
  }
  return {a_mm, {}, {}};
}

MaximumPermissibleError MaximumPermissibleError::linear(double a_mm, double k) {
  check_line(a_mm, k);
  return {a_mm, k, {}};
}

MaximumPermissibleError MaximumPermissibleError::lesser(double a_mm, double k, double b_mm) {
  check_line(a_mm, k);
  if (!(std::isfinite(b_mm) && b_mm > a_mm)) {
    throw std::invalid_argument(
        fmt::format("limit min(A + L/K, B): B = {} mm must be larger than A = {} mm", b_mm, a_mm));
  }
  return {a_mm, k, b_mm};
}

double MaximumPermissibleError::at(double length_mm) const {
  if (!(std::isfinite(length_mm) && length_mm >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("limit for a length of {} mm: lengths are not negative", length_mm));
  }
  if (!k_) return a_mm_;
  const double sloping_mm = a_mm_ + length_mm / micrometres_from_millimetres(*k_);
  return b_mm_ ? std::min(sloping_mm, *b_mm_) : sloping_mm;
}

std::string MaximumPermissibleError::text() const {
  if (!k_) return micrometres(a_mm_);
  const std::string sloping = fmt::format("{} + L/{:.6g}", micrometres(a_mm_), *k_);
  return b_mm_ ? fmt::format("min({}, {})", sloping, micrometres(*b_mm_)) : sloping;
}

}  // namespace armcal
