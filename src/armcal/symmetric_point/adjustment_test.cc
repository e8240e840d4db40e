// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/adjustment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "armcal/numerics/linear_algebra.h"
#include "armcal/symmetric_point/reading_model.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/wang2016_arm.h"
#include "armcal/testing/wang2016_unknowns.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

double value_of(const Adjustment& adjustment, const std::string& name) {
  const ParameterTable table(adjustment.arm);
  return table[table.find(name).value()].nominal;
}

AdjustmentOptions everything(const ArmModel& arm) {
  AdjustmentOptions options;
  for (int i = 0; i < ParameterTable(arm).size(); ++i) options.unknowns.push_back(i);
  return options;
}

// Half turns of random joints in random postures of an arm with exact or noisy distances.
std::vector<SymmetricReading> half_turns(const ArmModel& truth, int count, double sigma_mm,
                                         RandomStream& random) {
  std::vector<SymmetricReading> readings;
  for (int i = 0; i < count; ++i) {
    const auto posture = testing::random_posture(truth.joint_count(), random);
    const Eigen::VectorXd q =
        Eigen::Map<const Eigen::VectorXd>(posture.data(), truth.joint_count());
    const int joint = 1 + static_cast<int>(random.below(5));
    SymmetricReading reading =
        testing::reversal("h" + std::to_string(i + 1), joint, q, 0.0, "", sigma_mm);
    reading.value = predict(truth, reading).value + sigma_mm * random.normal();
    readings.push_back(reading);
  }
  return readings;
}

ArmModel true_romer(RandomStream& random) {
  const ArmModel nominal = testing::nominal_romer();
  const ParameterTable table(nominal);
  Eigen::VectorXd values = table.nominal();
  for (int i = 0; i < table.size(); ++i) {
    if (table[i].kind == ParameterKind::beta) continue;
    values(i) += (table[i].unit == ParameterUnit::mm ? 0.3 : 4e-4) * random.normal();
  }
  return with_parameter_values(nominal, values);
}

TEST(Adjustment, GivesThePapersArmInTheConsistentChain) {
  const Adjustment adjustment =
      adjust(testing::nominal_romer(), testing::wang2016_readings(104.700), testing::papers_five());
  ASSERT_TRUE(adjustment.ok());
  EXPECT_NEAR(value_of(adjustment, "a5"), 78.312, 0.001);
  EXPECT_NEAR(value_of(adjustment, "a7"), -25.962, 0.001);
  EXPECT_NEAR(value_of(adjustment, "b3"), 747.489, 0.001);
  EXPECT_NEAR(value_of(adjustment, "b5"), 531.880, 0.001);
  EXPECT_NEAR(value_of(adjustment, "b7"), 176.484, 0.001);
  EXPECT_EQ(adjustment.degrees_of_freedom, 1);
  EXPECT_FALSE(adjustment.has_flagged());
}

TEST(Adjustment, TellsThatNothingChecksThreeOfTheReadings) {
  const Adjustment adjustment =
      adjust(testing::nominal_romer(), testing::wang2016_readings(104.070), testing::papers_five());
  ASSERT_TRUE(adjustment.ok());
  // The misprint of l_PP3 goes whole into a5 and b3, and no test sees it.
  EXPECT_FALSE(adjustment.has_flagged());
  for (const AdjustedReading& reading : adjustment.readings) {
    const bool unchecked =
        reading.name == "l_PP3" || reading.name == "l_PP4" || reading.name == "l_PP5";
    if (unchecked) {
      EXPECT_EQ(reading.redundancy, 0.0) << reading.name;
      EXPECT_FALSE(reading.normalised.has_value());
      EXPECT_FALSE(reading.smallest_detectable.has_value());
      EXPECT_NEAR(reading.residual, 0.0, 1e-9);
    } else {
      EXPECT_GT(reading.redundancy, 0.001) << reading.name;
    }
  }
  double sum = 0.0;
  for (const AdjustedReading& reading : adjustment.readings) sum += reading.redundancy;
  EXPECT_NEAR(sum, 1.0, 1e-9);  // redundancy numbers add up to the degrees of freedom
}

TEST(Adjustment, AWrongRFailsTheOneCheckAndCannotBeToldFromItsPartners) {
  for (const double error : {0.1, -0.1}) {
    const Adjustment adjustment =
        adjust(testing::nominal_romer(), testing::wang2016_readings(104.700, 178.383 + error),
               testing::papers_five());
    ASSERT_TRUE(adjustment.ok());
    std::set<std::string> flagged;
    for (const AdjustedReading& reading : adjustment.readings) {
      if (!reading.flagged) continue;
      flagged.insert(reading.name);
      EXPECT_EQ(reading.inseparable_from.size(), 2u);
    }
    EXPECT_THAT(flagged, UnorderedElementsAre("R", "l_PP1", "l_PP2"));
    EXPECT_LT(adjustment.chi_squared_probability, 1e-6);
    EXPECT_NEAR(adjustment.readings[5].estimated_error.value(), error, 0.002);
  }
}

TEST(Adjustment, UsesEachReadingOnceAndWeighsIt) {
  // Two readings of the tip arm, one ten times as good: the weighted mean.
  auto readings = testing::wang2016_readings();
  readings.push_back(
      testing::reversal("again", 5, testing::degrees({0, 0, 0, 0, 0, -90}), 352.988, "", 0.03));
  readings.erase(readings.begin() + 5);  // without R
  const Adjustment adjustment = adjust(testing::nominal_romer(), readings, testing::papers_five());
  ASSERT_TRUE(adjustment.ok());
  const double weight = 1.0 / (0.003 * 0.003);
  const double other = 1.0 / (0.03 * 0.03);
  EXPECT_NEAR(value_of(adjustment, "b7"),
              (352.968 * weight + 352.988 * other) / (weight + other) / 2, 1e-9);
}

TEST(Adjustment, FortyVariedHalfTurnsDetermineAllTwentyOneParameters) {
  RandomStream random(40);
  const ArmModel truth = true_romer(random);
  const auto readings = half_turns(truth, 40, 0.005, random);
  AdjustmentOptions options = everything(truth);
  std::erase_if(options.unknowns,
                [&](int i) { return ParameterTable(truth)[i].kind == ParameterKind::beta; });
  const Adjustment adjustment = adjust(testing::nominal_romer(), readings, options);
  ASSERT_TRUE(adjustment.ok()) << explain(adjustment.status) << adjustment.detail;
  EXPECT_EQ(adjustment.unknowns.size(), 21u);
  EXPECT_EQ(adjustment.undetermined.size(), 8u);  // 29 parameters without beta
  EXPECT_LT(adjustment.condition_number, 200.0);
  EXPECT_FALSE(adjustment.has_flagged());
  std::set<std::string> held;
  for (const HeldParameter& parameter : adjustment.undetermined) held.insert(parameter.name);
  for (const char* name : {"zero1", "d2", "zero6"}) EXPECT_TRUE(held.count(name)) << name;
}

TEST(Adjustment, JointOneAloneDeterminesAllTwentyOne) {
  RandomStream random(41);
  const ArmModel truth = true_romer(random);
  auto readings = half_turns(truth, 60, 0.0, random);
  for (SymmetricReading& reading : readings) {
    reading = testing::reversal(reading.name, 1, reading.posture_rad, 0.0, "", 0.005);
    reading.value = predict(truth, reading).value;
  }
  AdjustmentOptions options = everything(truth);
  options.unknowns.resize(options.unknowns.size());
  const Adjustment adjustment = adjust(testing::nominal_romer(), readings, options);
  ASSERT_TRUE(adjustment.ok());
  EXPECT_EQ(adjustment.unknowns.size(), 21u);
}

TEST(Adjustment, ExactHalfTurnsGiveBackEveryLengthInsideTheArm) {
  // Parameters are a choice of convention; distances that were not used for it are not.
  RandomStream random(42);
  for (int trial = 0; trial < 5; ++trial) {
    const ArmModel truth = true_romer(random);
    auto readings = half_turns(truth, 60, 0.0, random);
    for (SymmetricReading& reading : readings) reading.u = 0.005;
    const Adjustment adjustment = adjust(testing::nominal_romer(), readings, everything(truth));
    ASSERT_TRUE(adjustment.ok()) << explain(adjustment.status);
    for (SymmetricReading& reading : half_turns(truth, 20, 0.0, random)) {
      reading.posture_end_rad = Eigen::VectorXd::Random(6) * 3.0;
      EXPECT_NEAR(predict(adjustment.arm, reading).value, predict(truth, reading).value, 1e-7);
    }
  }
}

TEST(Adjustment, CovarianceIsWhatSimulationShows) {
  RandomStream random(43);
  const ArmModel truth = testing::consistent_romer();
  auto readings = testing::wang2016_readings();
  const AdjustmentOptions options = testing::papers_five();
  double distance = 0.0;
  double chi_squared = 0.0;
  const int trials = 1000;
  for (int t = 0; t < trials; ++t) {
    for (SymmetricReading& reading : readings) {
      reading.value = predict(truth, reading).value + reading.u * random.normal();
    }
    const Adjustment adjustment = adjust(truth, readings, options);
    ASSERT_TRUE(adjustment.ok());
    Eigen::VectorXd error(5);
    for (Eigen::Index i = 0; i < 5; ++i) {
      const int index = adjustment.unknowns[static_cast<std::size_t>(i)];
      error(i) = adjustment.values(i) - parameter_values(truth)(index);
    }
    distance += error.dot(shortest_solution(adjustment.covariance, error)) / trials;
    chi_squared += adjustment.chi_squared / trials;
  }
  EXPECT_NEAR(distance, 5.0, 4.0 * std::sqrt(10.0 / trials));
  EXPECT_NEAR(chi_squared, 1.0, 4.0 * std::sqrt(2.0 / trials));
}

TEST(Adjustment, NamesTheOneWrongReadingAmongMany) {
  RandomStream random(44);
  int named = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const ArmModel truth = true_romer(random);
    auto readings = half_turns(truth, 60, 0.005, random);
    const std::size_t wrong = random.below(60);
    readings[wrong].value += 0.1;
    const Adjustment adjustment = adjust(testing::nominal_romer(), readings, everything(truth));
    ASSERT_TRUE(adjustment.ok());
    bool only = adjustment.readings[wrong].flagged;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (i != wrong && adjustment.readings[i].flagged) only = false;
    }
    if (only) ++named;
  }
  EXPECT_GE(named, 18);
}

TEST(Adjustment, SmallestDetectableErrorIsDetectedWithTheStatedPower) {
  RandomStream random(45);
  const ArmModel truth = testing::consistent_romer();
  auto readings = testing::wang2016_readings();
  const AdjustmentOptions options = testing::papers_five();
  for (SymmetricReading& reading : readings) reading.value = predict(truth, reading).value;
  const double error = adjust(truth, readings, options).readings[5].smallest_detectable.value();
  int detected = 0;
  const int trials = 1000;
  for (int t = 0; t < trials; ++t) {
    auto noisy = readings;
    for (SymmetricReading& reading : noisy) reading.value += reading.u * random.normal();
    noisy[5].value += error;
    if (adjust(truth, noisy, options).readings[5].flagged) ++detected;
  }
  EXPECT_NEAR(detected / static_cast<double>(trials), 0.80, 4.0 * std::sqrt(0.16 / trials));
}

TEST(Adjustment, SaysWhatTheReadingsCannotTellApart) {
  AdjustmentOptions options = testing::papers_five();
  const ParameterTable table(testing::nominal_romer());
  options.unknowns.push_back(table.find("zero6").value());
  options.unknowns.push_back(table.find("d2").value());
  const Adjustment adjustment =
      adjust(testing::nominal_romer(), testing::wang2016_readings(), options);
  ASSERT_TRUE(adjustment.ok());
  ASSERT_EQ(adjustment.undetermined.size(), 2u);
  EXPECT_EQ(adjustment.undetermined[0].reason, "zero6 moves every reading like a7 and b7 together");
  EXPECT_EQ(adjustment.undetermined[1].reason, "no reading depends on d2");
}

TEST(Adjustment, EndsWithAReason) {
  const ArmModel nominal = testing::nominal_romer();
  EXPECT_EQ(adjust(nominal, {}, testing::papers_five()).status, AdjustmentStatus::no_readings);
  const ParameterTable table(nominal);
  EXPECT_EQ(
      adjust(nominal, testing::wang2016_readings(), {.unknowns = {table.find("zero1").value()}})
          .status,
      AdjustmentStatus::nothing_determined);
  ArmModel tipless = nominal;
  tipless.tip = Tip{.d_mm = 10.0};
  const Adjustment undefined =
      adjust(tipless, testing::wang2016_readings(), testing::papers_five());
  EXPECT_EQ(undefined.status, AdjustmentStatus::not_defined);
  EXPECT_EQ(undefined.detail, "R");
}

}  // namespace
}  // namespace armcal
