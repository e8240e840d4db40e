// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/verification/control_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <stdexcept>

#include "armcal/core/random.h"
#include "armcal/numerics/distributions.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr ControlLimits kStandard = {0.0, 1.0};

// "2+4 3-7": rule, side, index of the value.
std::vector<std::string> found(const std::vector<double>& values,
                               const ControlLimits& limits = kStandard) {
  std::vector<std::string> names;
  for (const RuleViolation& each : violations_of(values, limits)) {
    names.push_back(std::to_string(static_cast<int>(each.rule)) +
                    (each.side == Side::above ? "+" : "-") + std::to_string(each.at));
  }
  return names;
}

TEST(ControlLimits, AreMeanAndMeanRangeOfNeighbours) {
  // Ranges 2, 1, 3: their mean 2 over 1.128.
  const ControlLimits limits = limits_of_baseline(std::vector<double>{10.0, 12.0, 11.0, 14.0});
  EXPECT_DOUBLE_EQ(limits.center, 11.75);
  EXPECT_NEAR(limits.sigma, 2.0 / 1.128, 1e-3);
  EXPECT_DOUBLE_EQ(limits.upper() - limits.lower(), 6.0 * limits.sigma);
  EXPECT_NEAR(kRangeOfTwo_sigma, 2.0 / std::sqrt(std::numbers::pi), 1e-15);
}

TEST(ControlLimits, FindTheSigmaOfNormalValues) {
  RandomStream random(1);
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) values.push_back(5.0 + 0.3 * random.normal());
  const ControlLimits limits = limits_of_baseline(values);
  // Sigma from moving ranges has a standard deviation of 0.91 sigma / sqrt(n): four of them.
  EXPECT_NEAR(limits.sigma, 0.3, 4.0 * 0.3 * 0.91 / std::sqrt(20000.0));
  EXPECT_NEAR(limits.center, 5.0, 4.0 * 0.3 / std::sqrt(20000.0));
}

TEST(ControlLimits, AreHardlyWidenedByASlowDrift) {
  RandomStream random(2);
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(random.normal() + 0.05 * i);
  // A standard deviation of these would be near 29.
  EXPECT_NEAR(limits_of_baseline(values).sigma, 1.0, 0.1);
}

TEST(ControlLimits, NeedTwoFiniteValues) {
  EXPECT_THROW(static_cast<void>(limits_of_baseline(std::vector<double>{1.0})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(limits_of_baseline(std::vector<double>{1.0, NAN})),
               std::invalid_argument);
}

TEST(ControlRules, OneValueBeyondThreeSigma) {
  EXPECT_THAT(found({0.5, 3.01, -0.5}), ElementsAre("1+1"));
  EXPECT_THAT(found({0.5, -3.01}), ElementsAre("1-1"));
  EXPECT_THAT(found({0.5, 3.0, -0.5}), IsEmpty());  // on the line is not beyond it
}

TEST(ControlRules, TwoOfThreeBeyondTwoSigmaOnOneSide) {
  EXPECT_THAT(found({2.1, -0.5, 2.1}), ElementsAre("2+2"));
  EXPECT_THAT(found({-2.1, -2.2}), ElementsAre("2-1"));
  EXPECT_THAT(found({2.1, -2.1, -0.1}), IsEmpty());          // not on one side
  EXPECT_THAT(found({2.1, 0.1, -0.1, 2.1}), IsEmpty());      // not of three
  EXPECT_THAT(found({2.1, 2.2, -0.1}), ElementsAre("2+1"));  // told once, where it happens
}

TEST(ControlRules, FourOfFiveBeyondOneSigmaOnOneSide) {
  EXPECT_THAT(found({1.1, 1.2, -0.3, 1.3, 1.1}), ElementsAre("3+4"));
  EXPECT_THAT(found({-1.1, -1.2, -1.3, -1.1}), ElementsAre("3-3"));
  EXPECT_THAT(found({1.1, 1.2, -0.3, 1.3, 0.9, -0.1, 1.1}), IsEmpty());
}

TEST(ControlRules, EightInARowOnOneSide) {
  EXPECT_THAT(found(std::vector<double>(7, 0.1)), IsEmpty());
  EXPECT_THAT(found(std::vector<double>(9, 0.1)), ElementsAre("4+7", "4+8"));
  std::vector<double> broken(9, -0.1);
  broken[4] = 0.0;  // on the line is on neither side
  EXPECT_THAT(found(broken), IsEmpty());
}

TEST(ControlRules, OneValueMayBreakSeveral) {
  EXPECT_THAT(found({1.5, 1.5, 2.5, 3.5}), ElementsAre("1+3", "2+3", "3+3"));
}

TEST(ControlRules, DependOnDistancesFromTheCentreInSigmasOnly) {
  RandomStream random(3);
  std::vector<double> plain;
  std::vector<double> moved;
  for (int i = 0; i < 300; ++i) {
    plain.push_back(1.5 * random.normal());
    moved.push_back(0.25 + 0.125 * plain.back());
  }
  EXPECT_GT(found(plain).size(), 20u);
  EXPECT_EQ(found(moved, {0.25, 0.125}), found(plain));
}

TEST(ControlRules, JudgeNothingWithoutScatter) {
  EXPECT_THAT(found({1.0, 1.0, 2.0}, {1.0, 0.0}), IsEmpty());
}

TEST(ControlRules, AreNamedInWords) {
  EXPECT_EQ(explain({ControlRule::eight_on_one_side, Side::above, 7}),
            "8 checks in a row above the centre line (rule 4)");
  EXPECT_EQ(explain({ControlRule::two_of_three_beyond_two, Side::below, 2}),
            "2 of 3 checks more than 2 sigma below the centre line (rule 2)");
}

/// Mean number of normal values until one breaks one of the rules: exact, from the Markov chain
/// whose states are what the rules remember, the last four values and the run on one side before
/// them. Values stand for their zones.
class MeanRunLength {
 public:
  explicit MeanRunLength(std::vector<ControlRule> rules) : rules_(std::move(rules)) {}

  double operator()() {
    expand({});
    std::vector<double> length(chain_.size(), 1.0);
    for (double change = 1.0; change > 1e-9;) {
      change = 0.0;
      for (std::size_t i = 0; i < chain_.size(); ++i) {
        double next = 1.0;
        for (const auto& [state, probability] : chain_[i]) next += probability * length[state];
        change = std::max(change, std::abs(next - length[i]));
        length[i] = next;
      }
    }
    return length[0];
  }

 private:
  using History = std::vector<double>;
  static constexpr std::array<double, 4> kZones = {0.5, 1.5, 2.5, 3.5};

  static double probability_of(double zone) {
    const double inner = std::abs(zone) - 0.5;
    if (inner == 3.0) return normal_cdf(-3.0);
    return normal_cdf(inner + 1.0) - normal_cdf(inner);
  }

  // What no rule can tell apart becomes equal: before the last four values only the sides of the
  // run count.
  static History remembered(const History& history) {
    std::size_t run = 1;
    while (run < history.size() && run < 7 &&
           history[history.size() - run - 1] * history.back() > 0.0) {
      ++run;
    }
    const std::size_t last = std::min<std::size_t>(4, history.size());
    History kept;
    for (std::size_t i = last; i < run; ++i) kept.push_back(std::copysign(0.5, history.back()));
    kept.insert(kept.end(), history.end() - static_cast<std::ptrdiff_t>(last), history.end());
    return kept;
  }

  [[nodiscard]] bool alarms(const History& history) const {
    for (const RuleViolation& each : violations_of(history, kStandard)) {
      if (each.at + 1 == history.size() &&
          std::find(rules_.begin(), rules_.end(), each.rule) != rules_.end()) {
        return true;
      }
    }
    return false;
  }

  std::size_t expand(const History& history) {
    const auto [known, is_new] = index_.emplace(history, chain_.size());
    const std::size_t index = known->second;
    if (!is_new) return index;
    chain_.emplace_back();
    std::vector<std::pair<std::size_t, double>> moves;
    for (const double zone : kZones) {
      for (const double value : {zone, -zone}) {
        History next = history;
        next.push_back(value);
        if (!alarms(next)) moves.emplace_back(expand(remembered(next)), probability_of(value));
      }
    }
    chain_[index] = std::move(moves);
    return index;
  }

  std::vector<ControlRule> rules_;
  std::map<History, std::size_t> index_;
  std::vector<std::vector<std::pair<std::size_t, double>>> chain_;
};

TEST(ControlRules, HaveThePublishedMeanRunLengths) {
  // Champ and Woodall 1987, Table 1, no shift; they round to 0.01.
  using enum ControlRule;
  EXPECT_NEAR(MeanRunLength({beyond_three_sigma})(), 370.40, 0.006);
  EXPECT_NEAR(MeanRunLength({beyond_three_sigma, two_of_three_beyond_two})(), 225.44, 0.006);
  EXPECT_NEAR(MeanRunLength({beyond_three_sigma, four_of_five_beyond_one})(), 166.05, 0.006);
  EXPECT_NEAR(MeanRunLength({beyond_three_sigma, eight_on_one_side})(), 152.73, 0.006);
  EXPECT_NEAR(MeanRunLength({beyond_three_sigma, two_of_three_beyond_two, four_of_five_beyond_one,
                             eight_on_one_side})(),
              91.75, 0.006);
}

TEST(ControlRules, AlarmFalselyAsOftenAsCalculated) {
  RandomStream random(4);
  constexpr int kRuns = 1000;
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<double> recent;
    for (bool quiet = true; quiet; ++sum) {
      recent.push_back(random.normal());
      if (recent.size() > 8) recent.erase(recent.begin());
      const auto violations = violations_of(recent, kStandard);
      quiet = violations.empty() || violations.back().at + 1 < recent.size();
    }
  }
  // Run lengths scatter by nearly their mean: four standard deviations of the mean of a thousand.
  EXPECT_NEAR(sum / kRuns, 91.75, 4.0 * 91.75 / std::sqrt(kRuns));
}

// Share of histories of a year of weeks, after a baseline of ten checks, in which a rule is broken.
double share_of_false_alarms(bool limits_are_known, double (*draw)(RandomStream&)) {
  constexpr int kHistories = 1000;
  int alarms = 0;
  for (std::uint64_t k = 0; k < kHistories; ++k) {
    RandomStream random(6, k);
    std::vector<double> values;
    for (int i = 0; i < 10 + 52; ++i) values.push_back(draw(random));
    const auto violations = violations_of(
        values, limits_are_known ? kStandard : limits_of_baseline(std::span(values).first(10)));
    alarms += std::any_of(violations.begin(), violations.end(),
                          [](const RuleViolation& each) { return each.at >= 10; })
                  ? 1
                  : 0;
  }
  return alarms / double{kHistories};
}

double largest_deviation_in_two_seats(RandomStream& random) {
  double largest = 0.0;
  for (int seat = 0; seat < 2; ++seat) {
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int i = 0; i < 10; ++i) {
      points.emplace_back(random.normal(), random.normal(), random.normal());
      mean += points.back() / 10.0;
    }
    for (const Eigen::Vector3d& point : points) largest = std::max(largest, (point - mean).norm());
  }
  return largest;
}

TEST(ControlRules, AlarmMoreOftenAfterAShortBaseline) {
  // The figures of theory/interim_check.md; four standard deviations of 1000 histories are 6 %.
  const auto normal = [](RandomStream& random) { return random.normal(); };
  EXPECT_NEAR(share_of_false_alarms(true, normal), 0.46, 0.06);
  EXPECT_NEAR(share_of_false_alarms(false, normal), 0.67, 0.06);
  EXPECT_NEAR(share_of_false_alarms(false, largest_deviation_in_two_seats), 0.73, 0.06);
}

}  // namespace
}  // namespace armcal
