// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/verification_job.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "armcal/core/units.h"
#include "armcal/io/arm_file.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/second_kinematics.h"
#include "armcal/testing/verification_in_folder.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::point_row;
using testing::sphere_rows;
using VerificationJobTest = testing::VerificationInFolder;

constexpr double kDiameter_mm = 25.0;
constexpr double kBall_mm = 6.0;

constexpr const char* kProbing = R"([[test]]
kind = "probing"
artefact = "ball"
file = "probing.csv"
probe_diameter_mm = 6
mpe_size_um = 30
mpe_form_um = 30
)";

// The ball of the probe stays its radius away: spheres of 31.01 and 30.98 mm are errors of +10 and
// -20 um, and the larger counts, with its sign.
TEST_F(VerificationJobTest, ReportsTheWorseOfTwoPositions) {
  folder_.write("probing.csv", "position,x_mm,y_mm,z_mm\n" +
                                   sphere_rows("A", {300, 0, 0}, (31.0 + 0.010) / 2, 25) +
                                   sphere_rows("B", {0, 700, 0}, (31.0 - 0.020) / 2, 25));
  const Verification verification = iso(kProbing);
  ASSERT_EQ(verification.statistics.size(), 2U);
  const Judged& size = verification.statistics[0].judged();
  EXPECT_EQ(size.result.symbol, "P_Size.Sph.1x25::Tact.AArm");
  EXPECT_NEAR(size.result.value_mm.value(), -0.020, testing::kExact_mm);
  EXPECT_EQ(size.verdict, Verdict::pass);
  EXPECT_NEAR(size.U_mm.value(), 0.001, 1e-12);  // of the certificate, k = 2 both times
  const Judged& form = verification.statistics[1].judged();
  EXPECT_EQ(form.result.symbol, "P_Form.Sph.1x25::Tact.AArm");
  EXPECT_NEAR(form.result.value_mm.value(), 0.0, testing::kExact_mm);
  EXPECT_EQ(verification.verdict(), Verdict::pass);
}

TEST_F(VerificationJobTest, FindsTheCloudOfFiveCentres) {
  // Four corners of a cube of edge 0.02 mm that are a regular tetrahedron, and its middle.
  std::string rows = "articulation,x_mm,y_mm,z_mm\n";
  const std::vector<Eigen::Vector3d> corners = {
      {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0, 0, 0}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    rows += sphere_rows(std::to_string(i + 1), Eigen::Vector3d(400, 300, 200) + 0.01 * corners[i],
                        (kDiameter_mm + kBall_mm) / 2, 5);
  }
  folder_.write("art.csv", rows);
  const Verification verification = iso(R"([[test]]
kind = "articulated_location"
artefact = "ball"
file = "art.csv"
probe_diameter_mm = 6
mpe_um = 30
)");
  const Judged& judged = verification.statistics.front().judged();
  EXPECT_EQ(judged.result.symbol, "L_Dia.5x5:Art:Tact.AArm");
  EXPECT_NEAR(judged.result.value_mm.value(), 0.02 * std::sqrt(3.0), 2e-9);  // of five-point fits
  EXPECT_EQ(judged.verdict, Verdict::fail);
}

/// 5 lengths at 7 positions, 3 times each, all 0.05 % too long.
std::string measured_rows(int positions, double scale) {
  std::string rows = "position,length_mm,repeat,measured_mm\n";
  for (int position = 1; position <= positions; ++position) {
    for (const double length : {200.0, 400.0, 600.0, 800.0, 1000.0}) {
      for (int repeat = 1; repeat <= 3; ++repeat) {
        rows += fmt::format("P{},{},{},{}\n", position, length, repeat, length * scale);
      }
    }
  }
  return rows;
}

TEST_F(VerificationJobTest, JudgesEveryLengthByItsOwnLimit) {
  folder_.write("lengths.csv", measured_rows(7, 1.0005));
  const Verification verification = iso(testing::kLengthTest);
  const Judged& judged = verification.statistics.front().judged();
  EXPECT_EQ(judged.result.symbol, "E_Uni");
  EXPECT_NEAR(judged.result.value_mm.value(), 0.5, testing::kExact_mm);
  EXPECT_NEAR(judged.mpe_mm.value(), 0.040, 1e-12);  // of 1000 mm: 500 um are 12.5 times as much
  EXPECT_EQ(verification.verdict(), Verdict::fail);
  EXPECT_EQ(verification.statistics.front().limit, "20 um + L/50");
  // What the file does not hold was not tested, and what it does not use was not measured on.
  EXPECT_THAT(verification.not_performed,
              ElementsAre("probing size and form errors", "articulated location error"));
  ASSERT_EQ(verification.artefacts.size(), 1U);
  EXPECT_EQ(verification.statistics.front().artefact, verification.artefacts.front().name);
}

TEST_F(VerificationJobTest, NamesWhatIsMissingAndComputesItOnlyIfAsked) {
  folder_.write("lengths.csv", measured_rows(6, 1.00001));
  EXPECT_THAT(iso_complaint(testing::kLengthTest), HasSubstr("7"));
  EXPECT_THAT(iso_complaint(testing::kLengthTest), HasSubstr("give --incomplete"));
  const Verification verification = iso(testing::kLengthTest, true);
  const Judged& judged = verification.statistics.front().judged();
  EXPECT_THAT(judged.result.symbol, IsEmpty());
  EXPECT_THAT(judged.result.missing, Not(IsEmpty()));
  EXPECT_EQ(judged.verdict, Verdict::pass);
}

TEST_F(VerificationJobTest, NamesMissingPointsAndPositions) {
  folder_.write("probing.csv",
                "position,x_mm,y_mm,z_mm\n" + sphere_rows("A", {300, 0, 0}, 15.5, 24));
  const std::string text = iso_complaint(kProbing);
  EXPECT_THAT(text, HasSubstr("24 points"));
  EXPECT_THAT(text, HasSubstr("1 sphere position"));
  EXPECT_THAT(text, HasSubstr("arm.verification.toml:12:"));
}

TEST_F(VerificationJobTest, RefusesAnotherSphereAndOtherUnitsEvenIfIncompleteIsAllowed) {
  folder_.write("probing.csv", "position,x_mm,y_mm,z_mm\n" +
                                   sphere_rows("A", {300, 0, 0}, 15.5, 25) +
                                   sphere_rows("B", {0, 700, 0}, 25.5, 25));
  EXPECT_THAT(iso_complaint(kProbing, true), HasSubstr("position B"));
  folder_.write("probing.csv", "position,x_mm,y_mm,z_mm\n" +
                                   sphere_rows("A", {300, 0, 0}, 15.5, 25) +
                                   sphere_rows("B", {0, 27, 0}, 15.5 / 25.4, 25));
  EXPECT_THAT(iso_complaint(kProbing, true), HasSubstr("25.4"));
}

TEST_F(VerificationJobTest, ReportsSeatsByZoneAndHalfRangesUnderTheirOwnName) {
  std::string rows = "position,x_mm,y_mm,z_mm\n";
  for (const double distance : {100.0, 500.0, 900.0}) {
    for (int i = 0; i < 10; ++i) {
      rows += point_row(fmt::format("{}", distance),
                        {distance, i % 2 == 0 ? 0.010 : -0.010, 1.0 + 1e-6 * i});
    }
  }
  folder_.write("seats.csv", rows);
  const Verification verification = asme(R"([[test]]
kind = "single_point_articulation"
file = "seats.csv"
mpe_um = 15
mpe_2s_um = 15
[[test]]
kind = "half_range"
file = "seats.csv"
)");
  ASSERT_EQ(verification.statistics.size(), 9U);
  EXPECT_THAT(verification.statistics[0].judged().result.name, HasSubstr("near"));
  // All deviations are 0.010 mm to the micrometre of z: 2 s = 2 sqrt(10/9) 0.010 mm.
  EXPECT_NEAR(verification.statistics[0].judged().result.value_mm.value(), 0.010, 1e-8);
  EXPECT_NEAR(verification.statistics[1].judged().result.value_mm.value(),
              0.020 * std::sqrt(10.0 / 9.0), 1e-8);
  EXPECT_EQ(verification.statistics[0].judged().verdict, Verdict::pass);
  EXPECT_EQ(verification.statistics[1].judged().verdict, Verdict::fail);
  const TestResult& half_range = verification.statistics[6].judged().result;
  EXPECT_NEAR(half_range.value_mm.value(), 0.010, testing::kExact_mm);
  EXPECT_THAT(half_range.name, HasSubstr("half range per axis"));
  EXPECT_THAT(half_range.name, Not(HasSubstr("articulation")));
}

// 1000 mm that expand by 1e-5 per kelvin are 1000.1 mm at 30 degC.
TEST_F(VerificationJobTest, TakesCertificatesToTheTemperatureOfTheTest) {
  folder_.write("length.csv", "measured_mm\n1000.1\n");
  const std::string path = folder_.write("warm.verification.toml", R"(
schema = "armcal.verification/1"
[environment]
temperature_c = 30
u_temperature_c = 0.4
[[artefact]]
name = "bar"
kind = "lengths"
lengths = [[1000, 6]]
expansion_per_c = 1e-5
[[test]]
kind = "length_uni"
artefact = "bar"
file = "length.csv"
u_repeatability_um = 12
mpe_um = 100
)");
  InputFiles files;
  VerificationWishes wishes;
  wishes.incomplete = true;
  const Verification verification = run_verification(files, path, wishes);
  const Judged& judged = verification.statistics.front().judged();
  EXPECT_NEAR(judged.result.value_mm.value(), 0.0, testing::kExact_mm);
  EXPECT_NEAR(judged.U_mm.value(), 2 * 0.013, 1e-12);  // 3, 4 and 12 um make 13 um
}

TEST_F(VerificationJobTest, JudgesByEveryRule) {
  folder_.write("lengths.csv", measured_rows(7, 1.00001));
  for (const char* rule :
       {"iso14253-1", "conformance-probability", "simple-acceptance", "guard-band"}) {
    const std::string path =
        folder_.write("rule.verification.toml",
                      fmt::format("{}{}[decision]\nrule = \"{}\"\n", testing::kVerificationHead,
                                  testing::kLengthTest, rule));
    InputFiles files;
    EXPECT_EQ(to_string(run_verification(files, path, {}).rule.kind), rule);
  }
}

/// Postures near each other, and the tips of an arm there by a kinematics that is not the
/// library's.
struct SeatPostures {
  explicit SeatPostures(RandomStream& random) {
    const auto middle = testing::random_posture(6, random, 1.0);
    for (int i = 0; i < 10; ++i) {
      std::vector<double> posture = middle;
      for (double& angle : posture) angle += 1e-4 * random.normal();
      degrees.emplace_back();
      for (const double angle : posture) degrees.back().push_back(degrees_from_radians(angle));
    }
  }

  [[nodiscard]] std::string table() const {
    std::string rows = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n";
    for (const auto& row : degrees) rows += fmt::format("{}\n", fmt::join(row, ","));
    return rows;
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> tips(const ArmModel& arm) const {
    const testing::SecondKinematics kinematics(arm, {});
    std::vector<Eigen::Vector3d> tips;
    for (const auto& row : degrees) {
      std::vector<double> posture;
      for (const double angle : row) posture.push_back(radians_from_degrees(angle));
      const auto tip = kinematics.tip<double>(nullptr, posture.data());
      tips.emplace_back(tip[0], tip[1], tip[2]);
    }
    return tips;
  }

  std::vector<std::vector<double>> degrees;
};

double largest_deviation_mm(const std::vector<Eigen::Vector3d>& tips) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& tip : tips) mean += tip / static_cast<double>(tips.size());
  double largest = 0.0;
  for (const auto& tip : tips) largest = std::max(largest, (tip - mean).norm());
  return largest;
}

// The same angles give what each of two arms would have measured.
TEST_F(VerificationJobTest, PutsAnglesThroughTheArmAsFoundAndAsLeft) {
  RandomStream random(1, 1);
  for (int trial = 0; trial < 10; ++trial) {
    const ArmModel as_found = testing::random_arm(6, random, {.harmonics = 1});
    ArmModel as_left = as_found;
    as_left.tip.a_mm += 20.0;
    const SeatPostures seat(random);
    folder_.write("found.arm.toml", arm_text(as_found));
    folder_.write("left.arm.toml", arm_text(as_left));
    folder_.write("seat.csv", seat.table());
    const std::string path = folder_.write("seat.verification.toml", R"(
schema = "armcal.verification/1"
arm = "found.arm.toml"
as_left = "left.arm.toml"
reach_mm = 20000
[[test]]
kind = "single_point_articulation"
file = "seat.csv"
)");
    InputFiles files;
    const Verification verification = run_verification(
        files, path, {.standard = VerificationStandard::b89_4_22, .incomplete = true});
    const VerifiedStatistic& largest = verification.statistics.front();
    EXPECT_NEAR(largest.as_found.result.value_mm.value(), largest_deviation_mm(seat.tips(as_found)),
                testing::kExact_mm);
    ASSERT_TRUE(largest.as_left);
    EXPECT_NEAR(largest.as_left->result.value_mm.value(), largest_deviation_mm(seat.tips(as_left)),
                testing::kExact_mm);
  }
}

TEST_F(VerificationJobTest, SaysWhenThereIsNothingToDo) {
  folder_.write("lengths.csv", measured_rows(7, 1.0));
  EXPECT_THAT(complaint(testing::kLengthTest, VerificationStandard::b89_4_22),
              HasSubstr("has no test of ASME B89.4.22-2004\n  help: its kinds are "
                        "effective_diameter"));
  EXPECT_THAT(iso_complaint("as_left = \"x\"\n"), HasSubstr("has no tests"));
}

TEST_F(VerificationJobTest, HasNoValueOfTooFewPoints) {
  folder_.write("probing.csv",
                "position,x_mm,y_mm,z_mm\n" + sphere_rows("A", {300, 0, 0}, 15.5, 3));
  EXPECT_ANY_THROW(static_cast<void>(iso(kProbing, true)));
}

TEST_F(VerificationJobTest, ReadsASharedTableOnce) {
  folder_.write("lengths.csv", measured_rows(7, 1.0));
  const std::string path = folder_.write(
      "two.verification.toml", std::string(testing::kVerificationHead) + testing::kLengthTest +
                                   testing::kLengthTest + "name = \"again\"\n");
  InputFiles files;
  const Verification verification = run_verification(files, path, {});
  EXPECT_EQ(verification.statistics.size(), 2U);
  EXPECT_EQ(files.records().size(), 2U);
}

}  // namespace
}  // namespace armcal
