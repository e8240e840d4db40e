// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "armcal/cli/command.h"
#include "armcal/io/arm_file.h"
#include "armcal/io/csv_text.h"
#include "armcal/simulation/symmetric_procedure.h"
#include "armcal/testing/half_turn_trial.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::tool;

std::vector<std::string> plan(const std::vector<std::string>& more,
                              const std::string& arm = "romer-infinite-2.0.arm.toml") {
  std::vector<std::string> line = {
      "plan", "symmetric-point", example("arms/" + arm), "--candidates", "300", "--starts", "2"};
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

TEST(PlanSymmetricPointCommand, PredictsTheResult) {
  const auto result = tool(plan({"--readings", "40", "--json"}));
  EXPECT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_EQ(json["rank"], 21);
  EXPECT_EQ(json["readings"].size(), 40u);
  EXPECT_EQ(json["parameters"].size(), 21u);
  EXPECT_LT(json["length_error_mm"].get<double>(), 0.004);
  EXPECT_GE(json["least_redundancy"].get<double>(), 0.1);
}

TEST(PlanSymmetricPointCommand, TheSeedDecidesAndThreadsDoNot) {
  const auto one = tool(plan({"--readings", "30", "--threads", "1"}));
  EXPECT_EQ(one.out, tool(plan({"--readings", "30", "--threads", "3"})).out);
  EXPECT_NE(one.out, tool(plan({"--readings", "30", "--seed", "2"})).out);
}

TEST(PlanSymmetricPointCommand, WritesTheWorksheet) {
  const TemporaryFolder folder;
  const std::string markdown = folder.path("sheet.md");
  const std::string csv = folder.path("sheet.csv");
  EXPECT_EQ(tool(plan({"--readings", "30", "--worksheet", markdown})).code, kDone);
  EXPECT_EQ(tool(plan({"--readings", "30", "--worksheet", csv})).code, kDone);
  EXPECT_THAT(testing::read_bytes(markdown), HasSubstr("| reading | turn | from | to | q1 |"));
  EXPECT_THAT(testing::read_bytes(csv), HasSubstr("reading,turn,from,to,q1,q2"));
  const auto again = tool(plan({"--readings", "30", "--worksheet", csv}));
  EXPECT_EQ(again.code, kWrongInput);
  EXPECT_THAT(again.err, HasSubstr("--force"));
}

// The whole way of a user: plan, carry out, fill in the table, calibrate.
TEST(PlanSymmetricPointCommand, TheFilledProcedureGivesTheCalibration) {
  const TemporaryFolder folder;
  const std::string procedure = folder.path("arm.symmetric.toml");
  const auto planned = tool(plan({"--readings", "40", "-o", procedure, "--json"}));
  ASSERT_EQ(planned.code, kDone) << planned.err;
  const auto unfilled = tool({"symmetric-point", procedure});
  EXPECT_EQ(unfilled.code, kWrongInput);

  // What an operator does with it, in the laboratory.
  HalfTurnPlan read;
  read.arm = testing::consistent_romer();
  read.wishes.repeats = 5;
  const Json json = planned.json();
  for (const auto& each : json["readings"]) {
    HalfTurn turn{each["joint"], testing::degrees(each["posture_deg"].get<std::vector<double>>()),
                  testing::degrees(each["posture_end_deg"].get<std::vector<double>>())};
    read.readings.push_back({each["name"], turn, 0, 0, 0, 0, 0});
  }
  const auto trial = testing::carry_out_plan(read, 11);
  std::string table = "reading,end,repeat,x_mm,y_mm,z_mm," + angle_header(6) + "\n";
  for (const SymmetricReading& reading : trial.procedure.readings) {
    for (std::size_t i = 0; i < reading.raw->points_mm.size(); ++i) {
      table += reading.name + "," + reading.raw->end[i] + "," + std::to_string(i) + "," +
               point_fields(reading.raw->points_mm[i]) + "," +
               angle_fields(reading.raw->encoder_rad.col(static_cast<Eigen::Index>(i))) + "\n";
    }
  }
  std::ofstream(folder.path("arm.csv"), std::ios::binary) << table;

  const std::string calibrated = folder.path("calibrated.arm.toml");
  const auto result = tool({"symmetric-point", procedure, "-o", calibrated, "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_EQ(result.json()["rank"], 21);
  Diagnostics diagnostics;
  const auto arm =
      read_arm({calibrated, testing::read_bytes(calibrated), "UTF-8", ""}, diagnostics);
  ASSERT_TRUE(arm) << diagnostics.to_text();
  const auto pairs = random_pairs(read.arm, {}, 200, 3);
  EXPECT_LT(length_error_mm(*arm, trial.truth, pairs), 0.008);
  EXPECT_GT(length_error_mm(read.arm, trial.truth, pairs), 0.2);
}

// A robot without a tool has its tip on the last axis: points show 16 parameters, half turns 15.
TEST(PlanSymmetricPointCommand, WarnsOfAnArmThatHidesParameters) {
  const auto result = tool(plan({"--json"}, "puma-560.arm.toml"));
  EXPECT_EQ(result.code, kDone);
  EXPECT_LT(result.json()["rank"], 21);
  EXPECT_THAT(result.err, HasSubstr("not the usual 21: as drawn, some move no distance"));
}

TEST(PlanSymmetricPointCommand, RefusesImpossibleWishesWithTheReason) {
  const auto few = tool(plan({"--readings", "15"}));
  EXPECT_EQ(few.code, kNumericalFailure);
  EXPECT_THAT(few.err, HasSubstr("15 half turns cannot determine 21 parameters"));
  const auto far = tool(plan({"--volume", "3000,3500,0,500,0,500"}));
  EXPECT_EQ(far.code, kNumericalFailure);
  EXPECT_THAT(far.err, HasSubstr("left the measuring volume"));
  const auto strict = tool(plan({"--readings", "24", "--min-redundancy", "0.3"}));
  EXPECT_EQ(strict.code, kNumericalFailure);
  EXPECT_THAT(strict.err, HasSubstr("not all can be above 0.300"));
}

TEST(PlanSymmetricPointCommand, RefusesNonsense) {
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--readings", "30.5"},
                                             {"--readings", "0"},
                                             {"--grid", "60"},
                                             {"--joints", "1,x"},
                                             {"--joints", "9"},
                                             {"--volume", "0,1,0,1"},
                                             {"--volume", "1,0,0,1,0,1"},
                                             {"--u-mm", "0"},
                                             {"--repeats", "-1"}}) {
    const auto result = tool(plan(wrong));
    EXPECT_NE(result.code, kDone) << wrong.front() << ' ' << wrong.back();
    EXPECT_NE(result.code, kBug) << result.err;
    EXPECT_TRUE(result.out.empty());
  }
}

}  // namespace
}  // namespace armcal::cli
