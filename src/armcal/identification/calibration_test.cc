// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/identification/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/core/units.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/random_geometry.h"
#include "armcal/testing/synthetic_readings.h"

namespace armcal {
namespace {

using testing::SyntheticReadings;

constexpr double kNoise_mm = 0.01;

ArmModel nominal_arm(int joints, std::uint64_t seed) {
  RandomStream random(seed, 0);
  return testing::random_arm(
      joints, random, {.arbitrary_twists = false, .beta = false, .harmonics = 0, .mount = false});
}

// Errors of the size that the start must bear: 5 mm and 2 deg.
ArmModel true_arm(const ArmModel& nominal, std::uint64_t seed) {
  RandomStream random(seed, 1);
  return testing::perturbed(nominal, random, 2.0, radians_from_degrees(0.8));
}

int count_free(const Calibration& calibration) { return static_cast<int>(calibration.free.size()); }

class JointCounts : public ::testing::TestWithParam<int> {};

TEST_P(JointCounts, GiveFourTimesAsManyParametersLessThree) {
  const int n = GetParam();
  const ArmModel nominal = nominal_arm(n, 100);
  SyntheticReadings readings(true_arm(nominal, 101), 102, kNoise_mm);
  const std::vector<ObservationGroup> groups = {readings.reference_points(60, "A")};
  const Calibration calibration = calibrate(nominal, groups, {});
  ASSERT_TRUE(calibration.ok()) << explain(calibration.status);
  EXPECT_EQ(count_free(calibration), 4 * n - 3);
  EXPECT_EQ(calibration.rank, 4 * n - 3 + 6);
  EXPECT_NEAR(calibration.sigma0, 1.0, 0.25);
}

INSTANTIATE_TEST_SUITE_P(From2To8, JointCounts, ::testing::Range(2, 9));

TEST(Calibrations, FindTheArmFromFiveMillimetresAndTwoDegreesAway) {
  int converged = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const ArmModel nominal = nominal_arm(6, 200 + seed);
    RandomStream random(seed, 9);
    const ArmModel truth = testing::perturbed(nominal, random, 5.0, radians_from_degrees(2.0));
    SyntheticReadings readings(truth, 300 + seed, kNoise_mm);
    const std::vector<ObservationGroup> groups = {readings.reference_points(80, "A"),
                                                  readings.reference_points(40, "B")};
    const Calibration calibration = calibrate(nominal, groups, {});
    converged += calibration.ok() && calibration.sigma0 < 1.2 && calibration.sigma0 > 0.8;
  }
  EXPECT_EQ(converged, 20);
}

// What two arms disagree in beyond the place of their bases: distances between random tips.
std::vector<double> distance_errors(const ArmModel& one, const ArmModel& other,
                                    std::uint64_t seed) {
  RandomStream random(seed, 5);
  const ForwardKinematics a(one);
  const ForwardKinematics b(other);
  std::vector<double> errors;
  for (int i = 0; i < 200; ++i) {
    const auto p = testing::random_posture(one.joint_count(), random);
    const auto q = testing::random_posture(one.joint_count(), random);
    errors.push_back((a.tip_in_base(p) - a.tip_in_base(q)).norm() -
                     (b.tip_in_base(p) - b.tip_in_base(q)).norm());
  }
  return errors;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

struct Mixture {
  const char* name;
  std::vector<ObservationGroup> (*make)(SyntheticReadings&);
  double largest_rms_mm;
};

std::vector<ObservationGroup> seats_and_length(SyntheticReadings& s) {
  std::vector<ObservationGroup> groups = {s.fixed_points({"P", "Q", "R"}, 40)};
  groups.push_back(s.length("P", "Q"));
  groups.push_back(s.length("Q", "R"));
  return groups;
}

const Mixture kMixtures[] = {
    {"tracker",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.reference_points(100, "A")};
     },
     0.02},
    {"tracker_poses",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.reference_poses(60, "A")};
     },
     0.02},
    {"seats_and_length", seats_and_length, 0.06},
    {"plates",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.artefact(6, 8, "one"), s.artefact(6, 8, "two")};
     },
     0.06},
    {"half_turns",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> { return {s.reversals(80)}; }, 0.05},
    {"half_turns_and_circles",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.reversals(60), s.circle_radii(60)};
     },
     0.05},
    {"ball_and_seats",
     [](SyntheticReadings& s) -> std::vector<ObservationGroup> {
       return {s.sphere(80, 30.0, true), s.fixed_points({"P", "Q"}, 40), s.plane(60),
               s.reversals(20)};
     },
     0.06},
};

class Mixtures : public ::testing::TestWithParam<Mixture> {};

TEST_P(Mixtures, RecoverTheArmToWhatTheirNoiseAllows) {
  const ArmModel nominal = nominal_arm(6, 400);
  const ArmModel truth = true_arm(nominal, 401);
  SyntheticReadings readings(truth, 402, kNoise_mm);
  const auto groups = GetParam().make(readings);
  const Calibration calibration = calibrate(nominal, groups, {});
  ASSERT_TRUE(calibration.ok()) << explain(calibration.status) << ' ' << calibration.detail << ' '
                                << to_string(calibration.termination);
  EXPECT_EQ(count_free(calibration), 21);
  EXPECT_NEAR(calibration.sigma0, 1.0, 0.3);
  EXPECT_GT(rms(distance_errors(nominal, truth, 403)), 1.0);
  EXPECT_LT(rms(distance_errors(calibration.arm, truth, 403)), GetParam().largest_rms_mm);
}

INSTANTIATE_TEST_SUITE_P(OfReferences, Mixtures, ::testing::ValuesIn(kMixtures),
                         [](const auto& each) { return std::string(each.param.name); });

// The truth in the conventions of the result: held parameters of the nominal arm, found from
// noiseless readings.
TEST(Calibrations, StateUncertaintiesThatHoldTheTruth) {
  const ArmModel nominal = nominal_arm(6, 500);
  const ArmModel truth = true_arm(nominal, 501);
  Eigen::VectorXd reference;
  int inside = 0;
  int count = 0;
  constexpr int kRuns = 30;
  for (int run = 0; run <= kRuns; ++run) {
    SyntheticReadings readings(truth, 600 + static_cast<std::uint64_t>(run),
                               run == 0 ? 1e-9 : kNoise_mm);
    std::vector<ObservationGroup> groups = {readings.reference_points(60, "A")};
    groups[0].u_mm.setConstant(kNoise_mm);
    const Calibration calibration = calibrate(nominal, groups, {});
    ASSERT_TRUE(calibration.ok()) << to_string(calibration.termination);
    const Eigen::VectorXd values = parameter_values(calibration.arm);
    if (run == 0) {
      reference = values;
      continue;
    }
    for (const int index : calibration.free) {
      const double u = calibration.parameters[static_cast<std::size_t>(index)].u;
      inside += std::abs(values(index) - reference(index)) < 1.96 * u;
      ++count;
    }
  }
  // 95 % within what 30 correlated runs scatter by; uncertainties are never narrowed, so rather
  // more.
  EXPECT_GT(inside, static_cast<int>(0.92 * count));
  EXPECT_LT(inside, static_cast<int>(0.985 * count));
}

// Readings with encoders that scatter: coordinates of a reference machine, half turns, a ball.
std::vector<ObservationGroup> by_noisy_encoders(const ArmModel& truth, std::uint64_t seed,
                                                double u_encoder_rad) {
  SyntheticReadings readings(truth, seed, kNoise_mm);
  std::vector<ObservationGroup> groups = {readings.reference_points(40, "A"),
                                          readings.reversals(40)};
  for (ObservationGroup& group : groups) {
    for (double& angle : group.encoder_rad.reshaped()) {
      angle += u_encoder_rad * readings.random().normal();
    }
    for (double& angle : group.encoder_end_rad.reshaped()) {
      angle += u_encoder_rad * readings.random().normal();
    }
  }
  return groups;
}

struct NoisyRuns {
  double mean_chi_squared_per_freedom = 0.0;
  double share_inside = 0.0;  // of parameters, within 1.96 u as stated, that is before widening
};

NoisyRuns calibrate_with_noisy_encoders(bool told) {
  constexpr double kEncoder_rad = 1e-4;  // 0.1 mm at a metre: ten times the noise of the reference
  constexpr int kRuns = 40;
  const ArmModel nominal = nominal_arm(6, 550);
  const ArmModel truth = true_arm(nominal, 551);
  NoisyRuns runs;
  Eigen::VectorXd reference;
  int count = 0;
  for (int run = 0; run <= kRuns; ++run) {
    const auto seed = static_cast<std::uint64_t>(5600 + run);
    auto groups = by_noisy_encoders(truth, seed, run == 0 ? 0.0 : kEncoder_rad);
    // The first is exact: the truth in the conventions of a result.
    if (run == 0) {
      SyntheticReadings exact(truth, seed, 1e-9);
      groups = {exact.reference_points(60, "A")};
    }
    for (ObservationGroup& group : groups) {
      if (told && run > 0) group.u_encoder_rad = kEncoder_rad;
    }
    const Calibration calibration = calibrate(nominal, groups, {});
    EXPECT_TRUE(calibration.ok()) << to_string(calibration.termination);
    const Eigen::VectorXd values = parameter_values(calibration.arm);
    if (run == 0) {
      reference = values;
      continue;
    }
    runs.mean_chi_squared_per_freedom +=
        calibration.chi_squared / calibration.degrees_of_freedom / kRuns;
    for (const int index : calibration.free) {
      const double u = calibration.parameters[static_cast<std::size_t>(index)].u /
                       std::max(1.0, calibration.sigma0);
      runs.share_inside += std::abs(values(index) - reference(index)) < 1.96 * u;
      ++count;
    }
  }
  runs.share_inside /= count;
  return runs;
}

TEST(Calibrations, ThatKnowTheirEncodersScatterStateRightUncertainties) {
  const NoisyRuns runs = calibrate_with_noisy_encoders(true);
  // 133 degrees of freedom, 40 runs: standard error 0.02.
  EXPECT_NEAR(runs.mean_chi_squared_per_freedom, 1.0, 0.06);
  EXPECT_GT(runs.share_inside, 0.92);
  EXPECT_LT(runs.share_inside, 0.985);
}

TEST(Calibrations, ThatTakeNoisyEncodersForExactStateWrongOnesAndAreFoundOut) {
  const NoisyRuns runs = calibrate_with_noisy_encoders(false);
  EXPECT_LT(runs.share_inside, 0.5);
  EXPECT_GT(runs.mean_chi_squared_per_freedom, 10.0);
}

TEST(Calibrations, RefuseFixedPointsThatDoNotKnowAMillimetre) {
  const ArmModel nominal = nominal_arm(6, 700);
  SyntheticReadings readings(true_arm(nominal, 701), 702, kNoise_mm);
  const std::vector<ObservationGroup> groups = {readings.fixed_points({"P", "Q"}, 60)};
  EXPECT_EQ(calibrate(nominal, groups, {}).status, CalibrationStatus::scale_unknown);
  const Calibration allowed = calibrate(nominal, groups, {.allow_rank_deficient = true});
  ASSERT_TRUE(allowed.ok()) << explain(allowed.status) << allowed.detail
                            << to_string(allowed.termination);
  EXPECT_EQ(count_free(allowed), 20);  // one less than with a length
  EXPECT_THAT(allowed.unseen.front().description, ::testing::HasSubstr("how long a millimetre is"));
  EXPECT_TRUE(calibrate(nominal, groups, {.prior_length_mm = 5.0}).ok());
  EXPECT_TRUE(calibrate(nominal, groups, {.hold = {"b3", "d4"}}).ok());
}

TEST(Calibrations, HoldWhatTheUserHoldsAndNoMore) {
  const ArmModel nominal = nominal_arm(6, 800);
  SyntheticReadings readings(true_arm(nominal, 801), 802, kNoise_mm);
  const std::vector<ObservationGroup> groups = {readings.reference_points(60, "A")};
  const Calibration calibration = calibrate(nominal, groups, {.hold = {"alpha*"}});
  ASSERT_TRUE(calibration.ok());
  for (const CalibratedParameter& each : calibration.parameters) {
    if (each.name.rfind("alpha", 0) == 0) {
      EXPECT_EQ(each.status, ParameterStatus::held);
      EXPECT_EQ(each.reason, "held by the user");
      EXPECT_EQ(each.value, each.nominal);
    }
  }
  EXPECT_GT(calibration.sigma0, 10.0);  // and the price is told
}

TEST(Calibrations, FindEncoderHarmonics) {
  const ArmModel nominal = nominal_arm(6, 900);
  ArmModel truth = true_arm(nominal, 901);
  truth.joints[2].harmonics = {{1e-4, -2e-4}};
  truth.joints[3].harmonics = {{-3e-4, 1e-4}};
  SyntheticReadings readings(truth, 902, kNoise_mm);
  const std::vector<ObservationGroup> groups = {readings.reference_points(150, "A")};
  EXPECT_GT(calibrate(nominal, groups, {}).sigma0, 3.0);
  const Calibration calibration = calibrate(nominal, groups, {.harmonics = 1});
  ASSERT_TRUE(calibration.ok());
  EXPECT_NEAR(calibration.sigma0, 1.0, 0.15);
  EXPECT_NEAR(calibration.arm.joints[3].harmonics[0].cos_rad, -3e-4, 2e-5);
  EXPECT_NEAR(calibration.arm.joints[2].harmonics[0].sin_rad, -2e-4, 2e-5);
}

TEST(Calibrations, JudgeHeldOutRowsWithoutLearningFromThem) {
  const ArmModel nominal = nominal_arm(6, 1000);
  SyntheticReadings readings(true_arm(nominal, 1001), 1002, kNoise_mm);
  std::vector<ObservationGroup> groups = {readings.reference_points(120, "A")};
  for (std::size_t row = 80; row < 120; ++row) groups[0].is_check[row] = true;
  const Calibration fitted = calibrate(nominal, groups, {});
  ASSERT_TRUE(fitted.groups[0].check.has_value());
  EXPECT_EQ(fitted.groups[0].fit.count, 80);
  EXPECT_EQ(fitted.groups[0].check->count, 40);
  // Three coordinates of noise, widened by what the fit does not know.
  EXPECT_NEAR(fitted.groups[0].check->rms_mm, std::sqrt(3.0) * kNoise_mm, 0.006);
  EXPECT_GT(*fitted.check_coverage, 0.85);
  groups[0].reference_mm.rightCols(40).array() += 3.0;  // held-out rows do not pull the fit
  const Calibration other = calibrate(nominal, groups, {});
  EXPECT_EQ(parameter_values(other.arm), parameter_values(fitted.arm));
  EXPECT_GT(other.groups[0].check->rms_mm, 3.0);
  EXPECT_LT(other.groups[0].check_registered->rms_mm, 0.1);  // a shift of all is the set-up's
}

TEST(Calibrations, NameRowsThatDoNotBelongToTheOthers) {
  const ArmModel nominal = nominal_arm(6, 1100);
  SyntheticReadings readings(true_arm(nominal, 1101), 1102, kNoise_mm);
  std::vector<ObservationGroup> groups = {readings.reference_points(100, "A")};
  groups[0].reference_mm(2, 41) += 1.0;
  const Calibration plain = calibrate(nominal, groups, {});
  const Calibration robust = calibrate(nominal, groups, {.loss = RobustLoss::cauchy});
  ASSERT_TRUE(robust.ok());
  ASSERT_EQ(robust.flagged.size(), 1u);
  EXPECT_EQ(robust.flagged[0].where.line, groups[0].lines[41]);
  EXPECT_EQ(plain.flagged.front().where.line, groups[0].lines[41]);
  EXPECT_LT(rms(distance_errors(robust.arm, readings.truth(), 1)),
            0.5 * rms(distance_errors(plain.arm, readings.truth(), 1)));
}

TEST(Calibrations, SayWhyTheyCannotStart) {
  const ArmModel nominal = nominal_arm(6, 1200);
  SyntheticReadings readings(nominal, 1201, kNoise_mm);
  const std::vector<ObservationGroup> two = {readings.reference_points(2, "A"),
                                             readings.reference_points(2, "B")};
  const Calibration calibration = calibrate(nominal, two, {});
  EXPECT_EQ(calibration.status, CalibrationStatus::cannot_start);
  EXPECT_THAT(calibration.detail, ::testing::HasSubstr("setup.A cannot be placed by its 2 points"));
  EXPECT_THAT(calibration.detail, ::testing::HasSubstr("setup.B"));
  EXPECT_EQ(calibrate(nominal, {}, {}).status, CalibrationStatus::no_readings);
  const std::vector<ObservationGroup> one = {readings.reference_points(1, "A")};
  EXPECT_EQ(calibrate(nominal, one, {}).status, CalibrationStatus::cannot_start);
}

TEST(Calibrations, ReportWhatPriorsBroughtAndWhatReadings) {
  const ArmModel nominal = nominal_arm(6, 1300);
  SyntheticReadings readings(true_arm(nominal, 1301), 1302, kNoise_mm);
  const std::vector<ObservationGroup> groups = {readings.reference_points(60, "A")};
  const Calibration calibration = calibrate(
      nominal, groups, {.prior_length_mm = 5.0, .prior_zero_rad = 0.05, .prior_twist_rad = 0.05});
  ASSERT_TRUE(calibration.ok());
  for (const CalibratedParameter& each : calibration.parameters) {
    if (each.status == ParameterStatus::prior) {
      EXPECT_LE(each.data_share, 1.0);
    }
    if (each.name == "a5" || each.name == "zero3") {
      EXPECT_GT(each.data_share, 0.9) << each.name;
    }
  }
}

TEST(Calibrations, AreTheSameOnAnyNumberOfThreads) {
  const ArmModel nominal = nominal_arm(6, 1400);
  SyntheticReadings readings(true_arm(nominal, 1401), 1402, kNoise_mm);
  const std::vector<ObservationGroup> groups = {readings.reference_points(3000, "A")};
  const Calibration one = calibrate(nominal, groups, {.threads = 1});
  const Calibration three = calibrate(nominal, groups, {.threads = 3});
  EXPECT_EQ(parameter_values(one.arm), parameter_values(three.arm));
  ASSERT_EQ(one.residuals.size(), three.residuals.size());
  for (std::size_t i = 0; i < one.residuals.size(); ++i)
    EXPECT_EQ(one.residuals[i].components, three.residuals[i].components);
}

TEST(Identifiability, PromisesWhatTheCalibrationKeeps) {
  const ArmModel nominal = nominal_arm(6, 1500);
  SyntheticReadings readings(true_arm(nominal, 1501), 1502, kNoise_mm);
  const auto groups = seats_and_length(readings);
  const Calibration look = identifiability(nominal, groups, {});
  const Calibration calibration = calibrate(nominal, groups, {});
  ASSERT_TRUE(look.ok() && calibration.ok());
  EXPECT_EQ(look.rank, calibration.rank);
  for (std::size_t i = 0; i < look.parameters.size(); ++i) {
    EXPECT_EQ(look.parameters[i].status, calibration.parameters[i].status)
        << look.parameters[i].name;
    if (look.parameters[i].u == 0.0) continue;
    EXPECT_NEAR(look.parameters[i].u / calibration.parameters[i].u, 1.0, 0.5)
        << look.parameters[i].name;
  }
}

TEST(TipCovariance, IsThatOfSimulatedCalibrations) {
  const ArmModel nominal = nominal_arm(6, 1600);
  const ArmModel truth = true_arm(nominal, 1601);
  RandomStream random(1602, 0);
  // Fixed to the base by holding nothing else: distances of the tip from the first axis, which no
  // set-up moves.
  const auto posture = testing::random_posture(6, random);
  const auto radius_of = [&](const ArmModel& arm) {
    const TipLinearisation at = ForwardKinematics(arm).linearise(posture);
    return std::hypot(at.tip_mm.x(), at.tip_mm.y());
  };
  double sum = 0.0;
  double squares = 0.0;
  double predicted = 0.0;
  constexpr int kRuns = 40;
  for (int run = 0; run < kRuns; ++run) {
    SyntheticReadings readings(truth, 1700 + static_cast<std::uint64_t>(run), kNoise_mm);
    const std::vector<ObservationGroup> groups = {readings.reference_points(60, "A")};
    const Calibration calibration = calibrate(nominal, groups, {});
    const double radius = radius_of(calibration.arm);
    sum += radius;
    squares += radius * radius;
    const TipLinearisation at = ForwardKinematics(calibration.arm).linearise(posture);
    const Eigen::Vector3d outward = Eigen::Vector3d(at.tip_mm.x(), at.tip_mm.y(), 0.0).normalized();
    const Eigen::Matrix3d covariance =
        tip_covariance(calibration.arm, calibration.free, calibration.covariance, posture);
    predicted += outward.dot(covariance * outward) / kRuns;
  }
  const double variance = (squares - sum * sum / kRuns) / (kRuns - 1);
  EXPECT_NEAR(std::sqrt(variance / predicted), 1.0, 0.35);
}

}  // namespace
}  // namespace armcal
