// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::tool;

TEST(CompareCommand, PrintsARowForEachChosenMethod) {
  const auto result = tool({"compare", "--methods", "cmm", "--methods", "paper-*"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.out, HasSubstr("least squares, reference CMM"));
  EXPECT_THAT(result.out, HasSubstr("symmetric points, as printed"));
  EXPECT_EQ(result.out.find("tracker"), std::string::npos);
}

TEST(CompareCommand, TakesSeedRepeatsAndScenario) {
  const auto result = tool({"compare", "--methods", "cmm", "--seed", "4", "--repeats", "2",
                            "--scenario", "seven-joint", "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_EQ(json["seed"], 4);
  EXPECT_EQ(json["repeats"], 2);
  EXPECT_EQ(json["scenario"], "seven-joint");
  EXPECT_EQ(json["methods"][0]["arms"], 2);
}

TEST(CompareCommand, DrawsItsArmsFromAScenarioFile) {
  const auto result = tool({"compare", "--methods", "nominal", "--methods", "cmm", "--json",
                            "--scenario", example("scenarios/digitizer.scenario.toml")});
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_GE(json["inputs"].size(), 2u);  // the scenario and its drawing
  const auto rms = [&](std::size_t row) {
    return json["methods"][row]["point_rms_mm"].get<double>();
  };
  EXPECT_GT(rms(0), 3.0 * rms(1));
}

TEST(CompareCommand, NamesTheScenariosThatThereAre) {
  const auto result = tool({"compare", "--scenario", "romeo"});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("no scenario is called \"romeo\"; built in: romer, "));
}

TEST(CompareCommand, WantsToDrawTheTruthItself) {
  const testing::TemporaryFolder folder;
  const std::string arm = example("arms/romer-infinite-2.0.arm.toml");
  const std::string file =
      folder.write("given.scenario.toml",
                   "schema = \"armcal.scenario/1\"\nname = \"given\"\narm = \"" + arm +
                       "\"\ntruth = \"" + arm + "\"\n[[measure]]\nwith = \"reference_cmm\"\n");
  const auto result = tool({"compare", "--scenario", file});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("the arms to compare on are drawn: leave out \"truth\""));
}

TEST(CompareCommand, GivesEveryMethodTheBudgetThatIsAskedFor) {
  const auto rms = [](const std::string& readings) {
    const Json json =
        tool({"compare", "--methods", "cmm", "--readings", readings, "--repeats", "3", "--json"})
            .json();
    EXPECT_EQ(json["methods"][0]["readings"], std::stoi(readings));
    return json["methods"][0]["point_rms_mm"].get<double>();
  };
  EXPECT_GT(rms("30"), 1.5 * rms("480"));
}

TEST(CompareCommand, GivesTheSameDigitsOnOneAndTwoThreads) {
  const auto digits = [](const std::string& threads) {
    Json json = tool({"compare", "--methods", "c*", "--json", "--threads", threads}).json();
    for (Json& method : json["methods"]) method.erase("seconds");
    json.erase("command_line");
    return json.dump();
  };
  EXPECT_EQ(digits("1"), digits("2"));
}

TEST(CompareCommand, WritesTheTableForAPageAndDoesNotOverwriteIt) {
  const testing::TemporaryFolder folder;
  const std::string page = folder.path("table.md");
  ASSERT_EQ(tool({"compare", "--methods", "cmm", "--markdown", page}).code, kDone);
  EXPECT_THAT(testing::read_bytes(page), HasSubstr("| method | readings | rms mm |"));
  EXPECT_EQ(tool({"compare", "--methods", "cmm", "--markdown", page}).code, kWrongInput);
}

TEST(CompareCommand, JudgesMethodsOnTheRowsThatASessionHoldsOut) {
  const auto result = tool({"compare", example("calibration/tracker.session.toml"), "--methods",
                            "least-squares*", "--methods", "nominal", "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_EQ(json["held_out"], 18);
  ASSERT_EQ(json["methods"].size(), 7u);
  const double nominal = json["methods"][0]["held_out"]["rms_mm"];
  const double geometry = json["methods"][1]["held_out"]["rms_mm"];
  EXPECT_LT(50.0 * geometry, nominal);
  EXPECT_GT(json["methods"][5]["condition_number"].get<double>(), 1e12);
  EXPECT_EQ(json["inputs"].size(), 3u);
}

TEST(CompareCommand, SplitsASessionThatHoldsNothingOut) {
  const auto result =
      tool({"compare", example("calibration/seats.session.toml"), "--methods", "least-squares"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_THAT(result.out, HasSubstr("43 held out (here: the session holds nothing out)"));
}

TEST(CompareCommand, RefusesWhatDoesNotGoTogether) {
  const std::string session = example("calibration/tracker.session.toml");
  EXPECT_THAT(tool({"compare", session, "--scenario", "romer"}).err,
              HasSubstr("--scenario, --repeats and --readings are for drawn arms"));
  EXPECT_EQ(tool({"compare", session, "--repeats", "2"}).code, kWrongInput);
  EXPECT_EQ(tool({"compare", session, "--paper-sphere"}).code, kWrongInput);
  EXPECT_THAT(tool({"compare", "--repeats", "2.5"}).err,
              HasSubstr("--repeats 2.5: must be a whole number from 1 to 1000000"));
  EXPECT_THAT(tool({"compare", "--seed", "-1"}).err,
              HasSubstr("--seed -1: must be a whole number from 0 to 2^53"));
  EXPECT_EQ(tool({"compare", "--scenario", "nobody"}).code, kWrongInput);
  const auto misspelt = tool({"compare", "--methods", "trackr"});
  EXPECT_EQ(misspelt.code, kWrongInput);
  EXPECT_THAT(misspelt.err, HasSubstr("did you mean \"tracker\"?"));
}

TEST(CompareCommand, StudiesThePapersSphere) {
  const auto result = tool({"compare", "--paper-sphere", "--repeats", "2", "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_EQ(result.json()["diameter_mm"], 15.8754);
  EXPECT_EQ(result.json()["effects"].size(), 11u);
}

}  // namespace
}  // namespace armcal::cli
