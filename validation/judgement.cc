// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "judgement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "armcal/numerics/distributions.h"

namespace armcal::validation {
namespace {

constexpr double kFull = 1000.0;               // trials for which the bounds are made
constexpr double kFactor = 1.959963984540054;  // of a 95 % interval
constexpr double kChance = 3.290526731491926;  // 99.9 % of a normal distribution

// Numbers of trials in which an interval holds the truth, by what is compared.
std::vector<int> counts_inside(const Plan& plan, std::span<const Trial> trials) {
  std::vector<int> inside(plan.names.size(), 0);
  for (const Trial& trial : trials) {
    for (std::size_t i = 0; i < trial.error.size(); ++i) {
      inside[i] += std::abs(trial.error[i]) <= kFactor * trial.u[i];
    }
  }
  return inside;
}

// The smallest and the largest coverage of quantities first .. last - 1.
void add_coverages(const Plan& plan, const std::vector<int>& inside, std::size_t first,
                   std::size_t last, int count, const std::string& what,
                   std::vector<Finding>& findings) {
  Band band = binomial_band(count);
  double lowest = 100.0 * band.fewest / count;
  double highest = 100.0 * band.most / count;
  if (count >= kFull) {
    lowest = 92.7;
    highest = 97.3;
  }
  const auto [least, most] =
      std::minmax_element(inside.begin() + static_cast<std::ptrdiff_t>(first),
                          inside.begin() + static_cast<std::ptrdiff_t>(last));
  for (const auto& [each, word] : {std::pair{least, "lowest"}, std::pair{most, "highest"}}) {
    findings.push_back({what + ", " + word + ", %", 100.0 * *each / count, lowest, highest,
                        plan.names[static_cast<std::size_t>(each - inside.begin())]});
  }
}

void add_bias(const Plan& plan, std::span<const Trial> trials, std::vector<Finding>& findings) {
  Finding bias{"largest bias / u", 0.0, 0.0, 0.12, ""};
  const auto count = static_cast<double>(trials.size());
  bias.highest *= std::sqrt(std::max(1.0, kFull / count));
  for (std::size_t i = 0; i < plan.parameter_count; ++i) {
    double sum = 0.0;
    for (const Trial& trial : trials) sum += trial.error[i] / trial.u[i];
    if (std::abs(sum) / count <= bias.value) continue;
    bias.value = std::abs(sum) / count;
    bias.note = plan.names[i];
  }
  findings.push_back(bias);
}

void add_sigma0(std::span<const Trial> trials, std::vector<Finding>& findings) {
  const auto count = static_cast<double>(trials.size());
  double sum = 0.0;
  double expected = 0.0;
  double freedom = 0.0;
  for (const Trial& trial : trials) {
    freedom += trial.degrees_of_freedom / count;
    sum += std::sqrt(trial.chi_squared / trial.degrees_of_freedom);
    expected += expected_sigma0(trial.degrees_of_freedom);
  }
  double width = 0.01;
  if (count < kFull) width = std::max(width, kChance / std::sqrt(2.0 * freedom * count));
  findings.push_back({"mean sigma0 / expected", sum / expected, 1.0 - width, 1.0 + width,
                      std::to_string(std::lround(freedom)) + " degrees of freedom"});
}

void add_rms_ratio(const Scenario& scenario, std::span<const Trial> trials,
                   std::vector<Finding>& findings) {
  double squares = 0.0;
  double floor = 0.0;
  for (const Trial& trial : trials) {
    squares += trial.squares_mm2;
    floor += trial.squares_floor_mm2;
  }
  const double ratio = std::sqrt(squares / floor);
  const auto count = static_cast<double>(trials.size());
  // Errors of an arm are common to all held-out points of a trial: as if each had one of 3 numbers.
  const double width = count < kFull ? kChance * 0.5 / std::sqrt(6.0 * count) : 0.0;
  Finding finding{"held-out RMS / noise floor", ratio, 1.0 - width,
                  scenario.largest_rms_ratio + width, ""};
  if (!scenario.model_is_complete) {
    finding.lowest = 1.2;
    finding.highest = HUGE_VAL;
  }
  findings.push_back(finding);
}

void add_coverage(const Plan& plan, std::span<const Trial> trials, std::vector<Finding>& findings) {
  const std::vector<int> inside = counts_inside(plan, trials);
  const int count = static_cast<int>(trials.size());
  add_coverages(plan, inside, 0, plan.parameter_count, count, "coverage of parameters", findings);
  add_coverages(plan, inside, plan.parameter_count, plan.names.size(), count,
                "coverage of predicted coordinates", findings);
  const auto parameters = static_cast<std::ptrdiff_t>(plan.parameter_count);
  const double mean = 100.0 * std::accumulate(inside.begin(), inside.begin() + parameters, 0.0) /
                      (static_cast<double>(count) * static_cast<double>(parameters));
  // At worst parameters err together, and their mean is no better known than one of them.
  const double width =
      count < kFull ? std::max(1.0, 100.0 * kChance * std::sqrt(0.95 * 0.05 / count)) : 1.0;
  char note[60];
  std::snprintf(note, sizeof note, "%.1f expected",
                100.0 * expected_coverage(trials.front().degrees_of_freedom));
  findings.push_back({"coverage, mean over parameters, %", mean, 95.0 - width,
                      std::min(100.0, 95.0 + width), plan.scenario->by_adjustment ? "" : note});
}

}  // namespace

std::vector<Finding> judge(const Plan& plan, std::span<const Trial> trials) {
  std::vector<Finding> findings;
  std::vector<Trial> good;
  int others = 0;
  double told = 0.0;
  std::string problem;
  for (const Trial& trial : trials) {
    if (!trial.problem.empty()) problem = trial.problem;
    others += !trial.same_unknowns;
    told += trial.says_scatter;
    if (trial.problem.empty() && trial.same_unknowns) good.push_back(trial);
  }
  const auto failed = static_cast<double>(trials.size() - good.size()) - others;
  findings.push_back({"calibrations that failed", failed, 0.0, 0.0, problem});
  findings.push_back({"calibrations of other unknowns", double(others), 0.0, 0.0, ""});
  if (good.empty()) return findings;
  if (plan.scenario->model_is_complete) {
    add_coverage(plan, good, findings);
    add_bias(plan, good, findings);
    add_sigma0(good, findings);
  } else {
    findings.push_back({"reports that say so, %", 100.0 * told / static_cast<double>(good.size()),
                        100.0, 100.0, "\"the readings scatter more than stated\""});
  }
  add_rms_ratio(*plan.scenario, good, findings);
  return findings;
}

double expected_coverage(double degrees_of_freedom) {
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double chi_squared = chi_squared_quantile((i + 0.5) / kSteps, degrees_of_freedom);
    const double widening = std::max(1.0, std::sqrt(chi_squared / degrees_of_freedom));
    sum += 2.0 * normal_cdf(kFactor * widening) - 1.0;
  }
  return sum / kSteps;
}

double expected_sigma0(double degrees_of_freedom) {
  const double half = degrees_of_freedom / 2.0;
  return std::exp(std::lgamma(half + 0.5) - std::lgamma(half)) / std::sqrt(half);
}

Band binomial_band(int count) {
  constexpr double kSuccess = 0.95;
  constexpr double kTail = 0.0005;
  const auto probability = [&](int successes) {
    const double log_choose = std::lgamma(count + 1.0) - std::lgamma(successes + 1.0) -
                              std::lgamma(count - successes + 1.0);
    return std::exp(log_choose + successes * std::log(kSuccess) +
                    (count - successes) * std::log(1.0 - kSuccess));
  };
  Band band{0, count};
  for (double tail = probability(0); tail < kTail; tail += probability(band.fewest)) ++band.fewest;
  for (double tail = probability(count); tail < kTail; tail += probability(band.most)) --band.most;
  return band;
}

}  // namespace armcal::validation
