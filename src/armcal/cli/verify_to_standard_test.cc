// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/verify_to_standard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::TemporaryFolder;
using testing::tool;

testing::ToolResult verify(const std::string& standard, const std::string& file,
                           const std::vector<std::string>& more = {}) {
  std::vector<std::string> line = {"verify", standard, file};
  line.insert(line.end(), more.begin(), more.end());
  return tool(line);
}

std::string verification_example(const std::string& name) {
  return example("verification/" + name + ".verification.toml");
}

const Json& named(const Json& tests, const std::string& symbol) {
  for (const Json& test : tests) {
    if (test["symbol"] == symbol) return test;
  }
  ADD_FAILURE() << "no test " << symbol;
  return tests[0];
}

TEST(VerifyToStandard, JudgesAsFoundAndAsLeftFromTheSameAngles) {
  const auto result = verify("iso10360-12", verification_example("reverification"), {"--json"});
  EXPECT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["as_found_verdict"], "fail");
  EXPECT_EQ(json["tests"].size(), 4U);
  const Json& length = named(json["tests"], "E_Uni");
  EXPECT_EQ(length["as_found"]["verdict"], "fail");
  EXPECT_EQ(length["as_left"]["verdict"], "pass");
  EXPECT_EQ(length["as_left"]["value_mm"], length["value_mm"]);
  EXPECT_EQ(length["parts"].size(), 105U);
  EXPECT_EQ(length["complete"], true);
  EXPECT_THAT(length["definition"].get<std::string>(), Not(IsEmpty()));
  EXPECT_EQ(json["inputs"].size(), 6U);
}

// The arm as found alone does not conform.
TEST(VerifyToStandard, FailsWithCode1) {
  const auto result = verify("iso10360-12", verification_example("reverification"),
                             {"--as-left", example("verification/as-found.arm.toml"), "--json"});
  EXPECT_EQ(result.code, kDoesNotConform) << result.err;
  EXPECT_EQ(result.json()["verdict"], "fail");
}

TEST(VerifyToStandard, FindsALongScaleWithLengthsOnly) {
  const auto wrong = verify("b89.4.22", verification_example("long-scale"), {"--json"});
  EXPECT_EQ(wrong.code, kDoesNotConform) << wrong.err;
  const Json tests = wrong.json()["tests"];
  int lengths = 0;
  for (const Json& test : tests) {
    const bool of_lengths = test["test"] == "volumetric_length";
    EXPECT_EQ(test["verdict"], of_lengths ? "fail" : "pass") << test["name"];
    lengths += of_lengths ? 1 : 0;
  }
  EXPECT_EQ(lengths, 2);
  const auto right = verify("b89.4.22", verification_example("long-scale"),
                            {"--arm", example("arms/romer-infinite-2.0.arm.toml")});
  EXPECT_EQ(right.code, kDone) << right.out << right.err;
}

// Form shows what a diameter would not: the printed tip, on one sphere, with a still wrist.
TEST(VerifyToStandard, ShowsThePrintedTipByItsForm) {
  const std::string file = verification_example("still-wrist");
  const auto result = verify("iso10360-12", file, {"--json"});
  EXPECT_EQ(result.code, kDoesNotConform) << result.err;
  const Json tests = result.json()["tests"];
  EXPECT_NEAR(std::abs(tests[0]["value_mm"].get<double>()), 0.1, 0.03);
  EXPECT_EQ(tests[0]["verdict"], "pass");
  EXPECT_GT(tests[1]["value_mm"].get<double>(), 2.0);
  EXPECT_EQ(tests[1]["verdict"], "fail");
  const auto right =
      verify("iso10360-12", file, {"--arm", example("arms/romer-infinite-2.0.arm.toml")});
  EXPECT_EQ(right.code, kDone) << right.out;
}

TEST(VerifyToStandard, NamesWhatIsMissingOfATest) {
  const TemporaryFolder folder;
  const std::string rows = testing::read_bytes(example("verification/still-wrist.csv"));
  folder.write("still-wrist.csv", rows.substr(0, rows.find("right,2,")));
  std::string text = testing::read_bytes(verification_example("still-wrist"));
  const std::string relative = "../arms/romer-infinite-2.0-as-printed.arm.toml";
  text.replace(text.find(relative), relative.size(), example("arms/romer-infinite-2.0.arm.toml"));
  const std::string file = folder.write("few.verification.toml", text);
  const auto refused = verify("iso10360-12", file);
  EXPECT_EQ(refused.code, kWrongInput);
  EXPECT_THAT(refused.err, HasSubstr("1 point at position right, 25 are asked for"));
  EXPECT_THAT(refused.err, HasSubstr("--incomplete"));
  folder.write("still-wrist.csv", rows.substr(0, rows.find("right,")));
  EXPECT_THAT(verify("iso10360-12", file).err, HasSubstr("1 sphere position, 2 are asked for"));
  const auto result = verify("iso10360-12", file, {"--incomplete"});
  EXPECT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Incomplete: not a test of the standard\n  probing: 1 sphere "
                                    "position, 2 are asked for"));
  EXPECT_THAT(result.out, Not(HasSubstr("P_Size.Sph")));
  const Json json = verify("iso10360-12", file, {"--incomplete", "--json"}).json();
  EXPECT_TRUE(json["tests"][0]["symbol"].is_null());
  EXPECT_EQ(json["tests"][0]["complete"], false);
}

/// One length, measured once: 1000 mm + error, U 10 um, MPE 40 um.
std::string one_length(const TemporaryFolder& folder, double error_mm) {
  folder.write("length.csv", "measured_mm\n" + std::to_string(1000.0 + error_mm) + "\n");
  return folder.write("one.verification.toml", R"(schema = "armcal.verification/1"
[[artefact]]
name = "bar"
kind = "lengths"
lengths = [[1000, 10]]
[[test]]
kind = "length_uni"
artefact = "bar"
file = "length.csv"
mpe_um = "20 + L/50"
)");
}

TEST(VerifyToStandard, IsUndecidedWithinTheUncertainty) {
  const TemporaryFolder folder;
  EXPECT_EQ(verify("iso10360-12", one_length(folder, 0.029), {"--incomplete"}).code, kDone);
  const auto undecided = verify("iso10360-12", one_length(folder, 0.035), {"--incomplete"});
  EXPECT_EQ(undecided.code, kUndecided);
  EXPECT_THAT(undecided.out, HasSubstr("undecided"));
  EXPECT_THAT(undecided.out, HasSubstr("Incomplete: not a test of the standard"));
  EXPECT_EQ(verify("iso10360-12", one_length(folder, 0.055), {"--incomplete"}).code,
            kDoesNotConform);
}

TEST(VerifyToStandard, HasNoValueOfTooFewPoints) {
  const TemporaryFolder folder;
  folder.write("seat.csv", "x_mm,y_mm,z_mm\n1,2,3\n");
  const std::string file = folder.write("seat.verification.toml", R"(
schema = "armcal.verification/1"
[[test]]
kind = "half_range"
file = "seat.csv"
)");
  const auto result = verify("b89.4.22", file, {"--incomplete"});
  EXPECT_EQ(result.code, kNumericalFailure);
  EXPECT_THAT(result.err, HasSubstr("the readings are too few to compute anything"));
}

TEST(VerifyToStandard, NamesFilesThatAreNotThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(verify("iso10360-12", folder.path("none.toml")).code, kWrongInput);
  const std::string file = one_length(folder, 0.0);
  std::filesystem::remove(folder.path("length.csv"));
  const auto result = verify("iso10360-12", file);
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("length.csv"));
}

TEST(VerifyToStandard, AsksForAnArmAsFoundWithOneAsLeft) {
  const TemporaryFolder folder;
  const auto result = verify("iso10360-12", one_length(folder, 0.0),
                             {"--as-left", example("arms/romer-infinite-2.0.arm.toml")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("names an arm as left but none as found"));
}

TEST(VerifyToStandard, RefusesAnArmOfOtherJoints) {
  const auto result = verify("iso10360-12", verification_example("reverification"),
                             {"--as-left", example("arms/seven-joint.arm.toml")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("has 7 joints"));
}

// Lengths that the table gives are those of one arm.
TEST(VerifyToStandard, WarnsWhereAnglesAreNotRecorded) {
  const TemporaryFolder folder;
  const std::string arm = example("arms/romer-infinite-2.0.arm.toml");
  const auto result = verify("iso10360-12", one_length(folder, 0.0),
                             {"--arm", arm, "--as-left", arm, "--incomplete"});
  EXPECT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.err, HasSubstr("length_uni is judged as found only"));
}

}  // namespace
}  // namespace armcal::cli
