// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::tool;

TEST(SymmetricPointCommand, NamesTheMisprintOfThePaper) {
  const auto result =
      tool({"symmetric-point", example("wang2016/as-printed.symmetric.toml"), "--json"});
  EXPECT_EQ(result.code, kDoesNotConform);
  int named = 0;
  const auto json = result.json();
  for (const auto& claim : json["claims"]) {
    if (claim["contradicted_by"].is_null()) continue;
    ++named;
    EXPECT_EQ(claim["contradicted_by"], "l_PP3");
    EXPECT_NEAR(claim["reconciled_by_mm"].get<double>(), 104.700, 1e-6);
  }
  EXPECT_EQ(named, 2);
}

TEST(SymmetricPointCommand, CalibratesTheConsistentArm) {
  const TemporaryFolder folder;
  const std::string output = folder.path("calibrated.arm.toml");
  const auto result = tool(
      {"symmetric-point", example("wang2016/as-meant.symmetric.toml"), "--json", "-o", output});
  EXPECT_EQ(result.code, kDone);
  const auto json = result.json();
  EXPECT_NEAR(json["adjusted"]["a5"]["value"].get<double>(), 78.312, 0.001);
  EXPECT_NEAR(std::abs(json["adjusted"]["a7"]["value"].get<double>()), 25.962, 0.001);
  EXPECT_NEAR(json["adjusted"]["b3"]["value"].get<double>(), 747.489, 0.001);
  EXPECT_NEAR(json["adjusted"]["b5"]["value"].get<double>(), 531.880, 0.001);
  EXPECT_NEAR(json["adjusted"]["b7"]["value"].get<double>(), 176.484, 0.001);
  EXPECT_EQ(json["inputs"].size(), 2u);
  EXPECT_THAT(testing::read_bytes(output), HasSubstr("Adjusted from"));
  EXPECT_EQ(tool({"fk", output, example("angles/six-joints.csv")}).code, kDone);
}

TEST(SymmetricPointCommand, SaysWhichNumbersOfThePrintedArmContradict) {
  const auto result = tool({"symmetric-point", example("wang2016/as-meant.symmetric.toml"),
                            "--compare", example("arms/romer-infinite-2.0-as-printed.arm.toml")});
  EXPECT_EQ(result.code, kDoesNotConform);
  EXPECT_THAT(result.out, HasSubstr("misses the readings by up to 305.274 mm (l_PP3)"));
  EXPECT_THAT(result.out, HasSubstr("b7 = 178.383 contradicts the readings, which give 176.484"));
  EXPECT_THAT(result.out, HasSubstr("It is the same length as the reading R."));
}

TEST(SymmetricPointCommand, RefusesBadProcedures) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      tool({"symmetric-point", folder.write("p.toml", "schema = \"armcal.symmetric/1\"\n")}).err,
      HasSubstr("arm is missing here"));
  EXPECT_EQ(tool({"symmetric-point", folder.write("q.toml", "garbage")}).code, kWrongInput);
}

// This pair of readings used to end the tool with a failed assertion.
TEST(SymmetricPointCommand, TellsWhichReadingsCannotBeAChain) {
  const TemporaryFolder folder;
  const std::string reading =
      "[[reading]]\nkind = \"circle_radius\"\njoint = 6\nradius_mm = 178.383\n";
  const auto result =
      tool({"symmetric-point",
            folder.write("p.toml", "schema = \"armcal.symmetric/1\"\narm = \"" +
                                       example("wang2016/nominal.arm.toml") + "\"\nu_mm = 0.003\n" +
                                       reading + "name = \"r1\"\nsolves = \"b7\"\n" + reading +
                                       "name = \"r2\"\nsolves = \"a7\"\n"),
            "--json"});
  EXPECT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.json()["chain_problem"].get<std::string>(),
              HasSubstr("r1, r2 cannot tell a7 from the rest"));
  EXPECT_EQ(result.json()["leakage_of"], "adjustment");
}

TEST(SymmetricPointCommand, ReadingsThatDetermineNothingAreCode4) {
  const TemporaryFolder folder;
  const auto result =
      tool({"symmetric-point",
            folder.write("p.toml",
                         "schema = \"armcal.symmetric/1\"\narm = \"" +
                             example("wang2016/nominal.arm.toml") +
                             "\"\nu_mm = 0.01\n[[reading]]\nkind = \"circle_radius\"\njoint = 6\n"
                             "radius_mm = 178\n[adjust]\nunknowns = [\"b3\"]\n")});
  EXPECT_EQ(result.code, kNumericalFailure);
  EXPECT_THAT(result.err, HasSubstr("the readings determine none of the parameters asked for"));
}

}  // namespace
}  // namespace armcal::cli
