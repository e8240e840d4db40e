// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/sign_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "armcal/arm/parameter_table.h"
#include "armcal/symmetric_point/reading_model.h"

namespace armcal {
namespace {

void turn_sign(ArmModel& arm, const std::string& name) {
  const ParameterTable table(arm);
  if (const auto index = table.find(name)) {
    Eigen::VectorXd values = table.nominal();
    values(*index) = -values(*index);
    arm = with_parameter_values(arm, values);
    return;
  }
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (name == fmt::format("direction{}", i + 1)) {
      arm.joints[i].direction = -arm.joints[i].direction;
      return;
    }
  }
  throw std::invalid_argument(fmt::format("unknown sign of \"{}\": no such parameter", name));
}

double misfit_of(const ArmModel& arm, std::span<const SymmetricReading> readings) {
  double sum = 0.0;
  double largest = 0.0;
  int count = 0;
  for (const SymmetricReading& reading : readings) {
    if (reading.is_angle())
      continue;  // which extremum was meant depends on the very signs in question
    const double difference = reading.value - predict(arm, reading).value;
    if (!std::isfinite(difference)) return std::numeric_limits<double>::infinity();
    sum += difference * difference;
    largest = std::max(largest, reading.value);
    ++count;
  }
  return count > 0 && largest > 0.0 ? std::sqrt(sum / count) / largest : 0.0;
}

// Two misfits closer than this are the same but for rounding.
bool is_equally_good(double one, double other) {
  return std::abs(one - other) <= 1e-9 * (one + other) + 1e-14;
}

}  // namespace

std::vector<SignCombination> search_signs(const ArmModel& nominal,
                                          std::span<const SymmetricReading> readings,
                                          std::span<const std::string> unknown_signs) {
  if (unknown_signs.size() > kMostUnknownSigns) {
    throw std::invalid_argument(fmt::format("{} unknown signs: at most {} can be tried jointly",
                                            unknown_signs.size(), kMostUnknownSigns));
  }
  std::vector<SignCombination> combinations;
  const std::size_t count = std::size_t{1} << unknown_signs.size();
  for (std::size_t mask = 0; mask < count; ++mask) {
    SignCombination combination;
    combination.arm = nominal;
    for (std::size_t i = 0; i < unknown_signs.size(); ++i) {
      if ((mask >> i & 1u) == 0) continue;
      turn_sign(combination.arm, unknown_signs[i]);
      combination.turned.push_back(unknown_signs[i]);
    }
    combination.misfit = misfit_of(combination.arm, readings);
    combinations.push_back(std::move(combination));
  }
  std::stable_sort(combinations.begin(), combinations.end(),
                   [](const SignCombination& one, const SignCombination& other) {
                     if (!is_equally_good(one.misfit, other.misfit))
                       return one.misfit < other.misfit;
                     return one.turned.size() < other.turned.size();
                   });
  return combinations;
}

std::size_t count_equally_good(std::span<const SignCombination> combinations) {
  std::size_t count = 0;
  while (count < combinations.size() &&
         is_equally_good(combinations[count].misfit, combinations.front().misfit)) {
    ++count;
  }
  return count;
}

}  // namespace armcal
