// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/symmetric_point_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kProcedureHead =
    "schema = \"armcal.symmetric/1\"\narm = \"../nominal.arm.toml\"\nu_mm = 0.003\n";

TextFile procedure_file(const std::string& text) {
  return {"folder/p.symmetric.toml", text, "UTF-8", ""};
}

SymmetricPointProcedure read_procedure(const std::string& text) {
  Diagnostics diagnostics;
  const auto procedure =
      read_symmetric_point_file(procedure_file(kProcedureHead + text), diagnostics);
  EXPECT_TRUE(procedure.has_value()) << diagnostics.to_text();
  return procedure.value_or(SymmetricPointProcedure{});
}

std::string complaint_about_procedure(const std::string& text) {
  Diagnostics diagnostics;
  auto procedure = read_symmetric_point_file(procedure_file(kProcedureHead + text), diagnostics);
  EXPECT_FALSE(procedure && check_against_arm(*procedure, testing::nominal_romer(), diagnostics));
  return diagnostics.to_text();
}

TEST(SymmetricPointFile, ReadsReducedAndRawReadings) {
  SymmetricPointProcedure procedure = read_procedure(R"(
[[reading]]
name = "l_PP1"
kind = "reversal"
joint = 5
posture_deg = [0, 0, 0, 0, 0, -90]
distance_mm = 352.968
solves = "b7"
[[reading]]
name = "R"
kind = "circle_radius"
joint = 6
radius_mm = 178.383
u_mm = 0.01
check = true
[[reading]]
name = "zero6"
kind = "zero_search"
joint = 6
posture_deg = [0, 0, 0, 0, 0, 2]
angle_deg = 1.5
u_deg = 0.02
[[reading]]
kind = "reversal"
joint = 3
posture_deg = [0, 0, 0, 0, 0, 0]
file = "l3.csv"
[adjust]
unknowns = ["a*", "b7"]
significance = 0.01
[signs]
unknown = ["a5", "direction4"]
[claims]
a5_mm = 78.312
alpha3_deg = -90
)");
  EXPECT_EQ(procedure.arm_file, "nominal.arm.toml");
  ASSERT_EQ(procedure.readings.size(), 4u);
  EXPECT_EQ(procedure.readings[0].value, 352.968);
  EXPECT_EQ(procedure.readings[0].u, 0.003);
  EXPECT_EQ(procedure.readings[0].solves, "b7");
  EXPECT_EQ(procedure.readings[1].u, 0.01);
  EXPECT_EQ(procedure.readings[2].sweep, 5);
  EXPECT_NEAR(procedure.readings[2].value, 1.5 * std::numbers::pi / 180, 1e-15);
  EXPECT_FALSE(procedure.readings[3].reduced);
  EXPECT_EQ(procedure.readings[3].name, "reading 4");
  EXPECT_EQ(procedure.readings[3].raw->file, "folder/l3.csv");
  EXPECT_THAT(procedure.unknowns, ElementsAre("a*", "b7"));
  EXPECT_EQ(procedure.significance, 0.01);
  EXPECT_EQ(procedure.claims[0].parameter, "a5");
  EXPECT_EQ(procedure.claims[1].value, -std::numbers::pi / 2);

  Diagnostics diagnostics;
  ASSERT_TRUE(check_against_arm(procedure, testing::nominal_romer(), diagnostics))
      << diagnostics.to_text();
  EXPECT_NEAR(procedure.readings[0].posture_end_rad(4), std::numbers::pi, 1e-15);
  EXPECT_EQ(procedure.readings[1].posture_rad.size(), 6);
}

TEST(SymmetricPointFile, NamesWhatIsWrongWithAReading) {
  EXPECT_THAT(complaint_about_procedure(""), HasSubstr("p.symmetric.toml: error: has no readings"));
  EXPECT_THAT(complaint_about_procedure("[[reading]]\nkind = \"reversl\"\njoint = 5\n"),
              HasSubstr("p.symmetric.toml:5:1: error: unknown kind \"reversl\"\n  help: did you "
                        "mean \"reversal\"?"));
  EXPECT_THAT(complaint_about_procedure(
                  "[[reading]]\nkind = \"reversal\"\njoint = 5\nposture_deg = [0,0,0,0,0,0]\n"),
              HasSubstr("reading \"reading 1\" has neither distance_mm nor file"));
  EXPECT_THAT(
      complaint_about_procedure("[[reading]]\nkind = \"reversal\"\njoint = 5\ndistance_mm = "
                                "-3\nposture_deg = [0,0,0,0,0,0]\n"),
      HasSubstr("distance_mm must be larger than 0"));
  EXPECT_THAT(complaint_about_procedure(
                  "[[reading]]\nkind = \"reversal\"\njoint = 5\ndistance_mm = 3\nu_mm = "
                  "0\nposture_deg = [0,0,0,0,0,0]\n"),
              HasSubstr("p.symmetric.toml:8:1: error: u_mm must be larger than 0"));
  EXPECT_THAT(
      complaint_about_procedure("[[reading]]\nkind = \"zero_search\"\njoint = 4\nangle_deg = "
                                "3\nposture_deg = [0,0,0,0,0,0]\n"),
      HasSubstr("has no uncertainty\n  help: give its u_deg"));
  EXPECT_THAT(complaint_about_procedure(
                  "[[reading]]\nkind = \"reversal\"\njoint = 5\ndistance = 3\nposture_deg = "
                  "[0,0,0,0,0,0]\n"),
              HasSubstr("unknown key \"distance\"\n  help: did you mean \"distance_mm\"?"));
}

TEST(SymmetricPointFile, NamesWhatDoesNotSuitTheArm) {
  const std::string good = "kind = \"reversal\"\ndistance_mm = 3\n";
  EXPECT_THAT(
      complaint_about_procedure("[[reading]]\n" + good +
                                "joint = 7\nposture_deg = [0,0,0,0,0,0]\n"),
      HasSubstr(
          "p.symmetric.toml:4:1: error: reading \"reading 1\": joint 7 of an arm with 6 joints"));
  EXPECT_THAT(
      complaint_about_procedure("[[reading]]\n" + good + "joint = 5\nposture_deg = [0,0]\n"),
      HasSubstr("posture_deg has 2 angles, the arm has 6 joints"));
  EXPECT_THAT(complaint_about_procedure("[[reading]]\n" + good + "joint = 5\n"),
              HasSubstr("has no posture_deg"));
  EXPECT_THAT(
      complaint_about_procedure("[[reading]]\n" + good +
                                "joint = 5\nsolves = \"b8\"\nposture_deg = [0,0,0,0,0,0]\n"),
      HasSubstr("solves = \"b8\": no such parameter\n  help: did you mean \"b"));
  EXPECT_THAT(complaint_about_procedure(
                  "[[reading]]\nkind = \"zero_search\"\njoint = 4\nsweep = 5\nangle_deg = "
                  "3\nu_deg = 1\nposture_deg = [0,0,0,0,0,0]\n"),
              HasSubstr("sweep = 5 is not a joint below joint 4"));
  const std::string fine = "[[reading]]\n" + good + "joint = 5\nposture_deg = [0,0,0,0,0,0]\n";
  EXPECT_THAT(complaint_about_procedure(fine + "[claims]\na9_mm = 3\n"),
              HasSubstr("claim of \"a9\": no such parameter"));
  EXPECT_THAT(complaint_about_procedure(fine + "[claims]\na5 = 3\n"),
              HasSubstr("claim \"a5\" has no unit\n  help: write a5_mm or a5_deg"));
  EXPECT_THAT(complaint_about_procedure(fine + "[adjust]\nunknowns = \"gamma*\"\n"),
              HasSubstr("no parameter is named \"gamma*\""));
  EXPECT_THAT(complaint_about_procedure(fine + "[signs]\nunknown = [\"direction9\"]\n"),
              HasSubstr("unknown sign of \"direction9\""));
  EXPECT_THAT(complaint_about_procedure(fine + fine.substr(0, fine.size() - 1) +
                                        "\nname = \"reading 1\"\n"),
              HasSubstr("two readings are named \"reading 1\""));
}

TEST(SymmetricPointFile, TurnsAJointTheOtherWayWhereItSaysSo) {
  const std::string head = "[[reading]]\nkind = \"reversal\"\njoint = 3\ndistance_mm = 100\n";
  SymmetricPointProcedure procedure =
      read_procedure(head + "posture_deg = [0, 0, 90, 0, 0, 0]\nturn_deg = -180\n");
  Diagnostics diagnostics;
  ASSERT_TRUE(check_against_arm(procedure, testing::nominal_romer(), diagnostics));
  EXPECT_NEAR(procedure.readings[0].posture_end_rad(2), -std::numbers::pi / 2.0, 1e-15);
  EXPECT_THAT(complaint_about_procedure(head + "posture_deg = [0, 0, 0, 0, 0, 0]\nturn_deg = 0\n"),
              HasSubstr(":9:1: error: turn_deg is 0: must be within +-360 and not 0"));
}

RC_GTEST_PROP(SymmetricPointFile, SurvivesAnyBytes, (const std::string& text)) {
  Diagnostics diagnostics;
  const bool read =
      read_symmetric_point_file(procedure_file(kProcedureHead + text), diagnostics).has_value();
  RC_ASSERT(read != diagnostics.has_errors());
}

TEST(SymmetricPointFile, ReadsTheUncertaintyOfTheEncoders) {
  const std::string reading = "[[reading]]\nkind = \"circle_radius\"\njoint = 6\nradius_mm = 178\n";
  EXPECT_EQ(read_procedure(reading).u_encoder_rad, 0.0);
  EXPECT_NEAR(read_procedure("u_encoder_arcsec = 2\n" + reading).u_encoder_rad, 9.6963e-6, 1e-10);
  EXPECT_THAT(complaint_about_procedure("u_encoder_arcsec = -1\n" + reading),
              HasSubstr("u_encoder_arcsec must not be negative"));
}

}  // namespace
}  // namespace armcal
