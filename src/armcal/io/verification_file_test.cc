// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/verification_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace armcal {
namespace {

using ::testing::HasSubstr;

constexpr const char* kVerificationHead = R"(schema = "armcal.verification/1"
)";
constexpr const char* kSphere = R"(
[[artefact]]
name = "ball"
kind = "sphere"
diameter_mm = 25.0003
U_um = 0.4
form_um = 0.1
expansion_per_c = 5.5e-6
u_expansion_per_c = 0.5e-6
certificate = "K-2026-1"
)";
constexpr const char* kProbing = R"(
[[test]]
kind = "probing"
artefact = "ball"
file = "ball.csv"
probe_diameter_mm = 6
mpe_size_um = 30
mpe_form_um = "40"
)";

std::optional<VerificationFile> read_file(const std::string& text, Diagnostics& diagnostics) {
  return read_verification_file({"tests/arm.verification.toml", text, "UTF-8", ""}, diagnostics);
}

/// Everything that is said of a file that cannot be used.
std::string complaints(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_file(text, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
  return diagnostics.to_text();
}

TEST(VerificationFile, IsReadWithItsPathsBesideIt) {
  Diagnostics diagnostics;
  const auto file = read_file(std::string(kVerificationHead) + R"(name = "arm 123"
arm = "as-found.arm.toml"
as_left = "as-left.arm.toml"
reach_mm = 1250
[decision]
rule = "guard-band"
coverage_factor = 2.5
guard_factor = 0.5
[environment]
temperature_c = 20.4
u_temperature_c = 0.3
)" + kSphere + kProbing,
                              diagnostics);
  ASSERT_TRUE(file) << diagnostics.to_text();
  EXPECT_EQ(file->name, "arm 123");
  EXPECT_EQ(file->arm_file, "tests/as-found.arm.toml");
  EXPECT_EQ(file->as_left_file, "tests/as-left.arm.toml");
  EXPECT_EQ(file->reach_mm, 1250.0);
  EXPECT_EQ(file->decision.rule, "guard-band");
  EXPECT_EQ(file->decision.coverage_factor, 2.5);
  EXPECT_EQ(file->decision.guard_factor, 0.5);
  EXPECT_EQ(file->environment.temperature_C, 20.4);
  const StatedArtefact* ball = file->artefact("ball");
  ASSERT_NE(ball, nullptr);
  EXPECT_NEAR(ball->U_mm, 0.0004, 1e-15);
  EXPECT_NEAR(ball->form_mm, 0.0001, 1e-15);
  EXPECT_EQ(ball->coverage_factor, 2.0);
  ASSERT_EQ(file->tests.size(), 1U);
  const StatedTest& test = file->tests.front();
  EXPECT_EQ(test.name, "probing");
  EXPECT_EQ(test.file, "tests/ball.csv");
  EXPECT_EQ(test.probe_diameter_mm, 6.0);
  ASSERT_TRUE(test.limit && test.second_limit);
  EXPECT_NEAR(test.limit->a_mm, 0.030, 1e-15);
  EXPECT_NEAR(test.second_limit->a_mm, 0.040, 1e-15);
}

TEST(VerificationFile, TakesLengthsInPlace) {
  Diagnostics diagnostics;
  const auto file = read_file(std::string(kVerificationHead) + R"(
[[artefact]]
name = "bar"
kind = "lengths"
lengths = [[500.0012, 0.6], [1000.0031, 1.1]]
[[test]]
kind = "length_uni"
artefact = "bar"
file = "bar.csv"
mpe_um = "20 + L/50"
)",
                              diagnostics);
  ASSERT_TRUE(file) << diagnostics.to_text();
  ASSERT_EQ(file->artefacts.front().lengths.size(), 2U);
  EXPECT_EQ(file->artefacts.front().lengths[1].length_mm, 1000.0031);
  EXPECT_NEAR(file->artefacts.front().lengths[1].U_mm, 0.0011, 1e-15);
  ASSERT_TRUE(file->tests.front().limit);
  EXPECT_EQ(file->tests.front().limit->k, 50.0);
}

TEST(VerificationFile, NamesEveryMistakeWithLineAndRemedy) {
  const std::string text = complaints(std::string(kVerificationHead) + R"([decision]
rule = "iso14253"
probability = 1.5
[[artefact]]
name = "ball"
kind = "spere"
diameter_mm = -25
[[test]]
kind = "probing"
artefact = "ball"
file = "ball.csv"
mpe_size_um = "30 um"
mpe_form_um = "20 + L/50"
mpe_um = 30
)");
  EXPECT_THAT(text, HasSubstr("arm.verification.toml:3:1: error: unknown rule \"iso14253\""));
  EXPECT_THAT(text, HasSubstr("did you mean \"iso14253-1\"?"));
  EXPECT_THAT(text, HasSubstr(":4:1: error: probability is 1.5: must be at least 0.5 and below 1"));
  EXPECT_THAT(text, HasSubstr("unknown kind \"spere\""));
  EXPECT_THAT(text, HasSubstr("diameter_mm is -25: must be larger than 0"));
  EXPECT_THAT(text, HasSubstr("mpe_size_um \"30 um\" is no limit"));
  EXPECT_THAT(text, HasSubstr("\"20 + L/50\" or \"min(20 + L/50, 80)\""));
  EXPECT_THAT(text,
              HasSubstr("mpe_form_um \"20 + L/50\" depends on a length, and this test has none"));
  EXPECT_THAT(text, HasSubstr("unknown key \"mpe_um\""));
}

TEST(VerificationFile, AsksForTheArtefactOfATest) {
  EXPECT_THAT(complaints(std::string(kVerificationHead) + kProbing),
              HasSubstr("no artefact is named \"ball\"\n  help: describe it: [[artefact]]"));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + kSphere + R"([[test]]
kind = "length_uni"
artefact = "ball"
file = "f.csv"
)"),
              HasSubstr("length_uni needs calibrated lengths, and \"ball\" is a sphere"));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + kSphere + kSphere + kProbing),
              HasSubstr("two artefacts are named \"ball\""));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + kSphere + R"([[test]]
kind = "half_range"
artefact = "ball"
file = "f.csv"
)"),
              HasSubstr("half_range is measured in a seat: it has no artefact"));
}

TEST(VerificationFile, RefusesNonsense) {
  EXPECT_THAT(complaints(kVerificationHead),
              HasSubstr("has no tests\n  help: write one [[test]] for each"));
  EXPECT_THAT(complaints("test = 3\n"), HasSubstr("has no schema"));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + "test = 3\n"),
              HasSubstr("test must be tables, each headed [[test]]"));
  EXPECT_THAT(complaints("schema = \"armcal.session/1\"\n"),
              HasSubstr("schema \"armcal.session/1\" is not \"armcal.verification/1\""));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + "reach_mm = 1e9\n" + kSphere + kProbing),
              HasSubstr("longer than a kilometre"));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + "[environment]\ntemperature_c = 293\n" +
                         kSphere + kProbing),
              HasSubstr("temperatures are in degrees Celsius"));
  EXPECT_THAT(complaints(std::string(kVerificationHead) + R"([[artefact]]
name = "bar"
kind = "lengths"
expansion_per_c = 11.5
lengths = []
)"),
              HasSubstr("no material expands so much\n  help: steel is 11.5e-6"));
}

}  // namespace
}  // namespace armcal
