// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

// calibrate and the commands that live on what it saves: identifiability, predict, diff, probe.
namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using testing::tool;

const std::string kTracker = example("calibration/tracker.session.toml");
const std::string kSeats = example("calibration/seats.session.toml");

TEST(CalibrateCommand, WritesAnArmAndACalibrationThatOthersRead) {
  const testing::TemporaryFolder folder;
  const auto result = tool(
      {"calibrate", kTracker, "-o", folder.path("arm.arm.toml"), "--save", folder.path("c.json")});
  ASSERT_EQ(result.code, kDone) << result.err;
  const auto tips =
      tool({"predict", folder.path("c.json"), example("angles/six-joints.csv"), "--json"});
  const auto plain =
      tool({"fk", folder.path("arm.arm.toml"), example("angles/six-joints.csv"), "--json"});
  ASSERT_EQ(tips.code, kDone) << tips.err;
  EXPECT_EQ(tips.json()["tips_mm"], plain.json()["tips_mm"]);
  const Json u_mm = tips.json()["u_mm"][1];
  for (const auto& u : u_mm) EXPECT_GT(u.get<double>(), 0.001);
  EXPECT_EQ(tool({"calibrate", kTracker, "-o", folder.path("arm.arm.toml")}).code,
            kWrongInput);  // is there already
}

TEST(CalibrateCommand, NamesTheKnockedReading) {
  const auto result = tool({"calibrate", kTracker});
  EXPECT_THAT(result.out, HasSubstr("tracker.csv:43: off by 1.2"));
}

TEST(CalibrateCommand, EndsWith4WhereSizeIsUnknown) {
  const testing::TemporaryFolder folder;
  const std::string session = folder.write(
      "s.session.toml", "schema = 'armcal.session/1'\narm = '" +
                            example("calibration/digitizer.arm.toml") +
                            "'\nangles = 'deg'\n[[observations]]\nkind = 'fixed_point'\nfile = '" +
                            example("calibration/seats.csv") + "'\nu_mm = 0.02\n");
  const auto refused = tool({"calibrate", session});
  EXPECT_EQ(refused.code, kNumericalFailure);
  EXPECT_THAT(refused.err, HasSubstr("no reading knows how long a millimetre is"));
  EXPECT_THAT(refused.err, HasSubstr("--allow-rank-deficient"));
  const auto allowed = tool({"calibrate", session, "--allow-rank-deficient"});
  EXPECT_EQ(allowed.code, kDone) << allowed.err;
  EXPECT_THAT(allowed.out, HasSubstr("held, the longest"));
  EXPECT_THAT(tool({"identifiability", session}).out,
              HasSubstr("no reading knows how long a millimetre is"));
}

TEST(CalibrateCommand, EndsWith2ForWhatIsNoSession) {
  EXPECT_EQ(tool({"calibrate", example("calibration/tracker.csv")}).code, kWrongInput);
  EXPECT_EQ(tool({"calibrate", "absent.session.toml"}).code, kWrongInput);
  EXPECT_THAT(tool({"calibrate", example("calibration/digitizer.arm.toml")}).err,
              HasSubstr("armcal.session/1"));
}

TEST(IdentifiabilityCommand, CountsWhatTheReadingsDetermine) {
  const auto result = tool({"identifiability", kSeats, "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  EXPECT_EQ(result.json()["rank"], 21 + 18);
}

TEST(PredictCommand, AsksForACalibrationWhereAnArmIsGiven) {
  const auto result =
      tool({"predict", example("arms/ur10.arm.toml"), example("angles/six-joints.csv")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("has no covariance"));
  EXPECT_THAT(result.err, HasSubstr("armcal fk"));
}

TEST(PredictCommand, ComplainsOfBrokenCalibrations) {
  const testing::TemporaryFolder folder;
  for (const char* text : {"{", "{}", "{\"arm\": 3}", "{\"arm\": \"schema = 'armcal.arm/1'\"}"}) {
    const auto result =
        tool({"predict", folder.write("c.json", text), example("angles/six-joints.csv")});
    EXPECT_EQ(result.code, kWrongInput) << text;
    EXPECT_THAT(result.err, HasSubstr("c.json")) << text;
  }
}

TEST(DiffCommand, FindsNoChangeBetweenTwoMethodsAndItself) {
  const std::string one = example("calibration/tracker.calibration.json");
  const std::string other = example("calibration/seats.calibration.json");
  const Json changes = tool({"diff", one, other, "--json"}).json()["changes"];
  for (const auto& change : changes) {
    if (change["ratio"].is_null()) continue;
    EXPECT_LT(std::abs(change["ratio"].get<double>()), 3.5) << change["name"];
  }
  const Json none = tool({"diff", one, one, "--json"}).json()["changes"];
  for (const auto& change : none) EXPECT_EQ(change["change"], 0.0);
}

TEST(ProbeCommand, FindsTheTipInASeat) {
  const testing::TemporaryFolder folder;
  // The seat "left_a" of the example, with an arm whose tip is described wrongly.
  std::string rows;
  std::istringstream seats(testing::read_bytes(example("calibration/seats.csv")));
  for (std::string line; std::getline(seats, line);) {
    if (line.rfind("point,", 0) == 0 || line.rfind("left_a,", 0) == 0)
      rows += line.substr(line.find(',') + 1) + '\n';
  }
  const std::string arm = folder.path("arm.arm.toml");
  ASSERT_EQ(tool({"calibrate", kSeats, "-o", arm}).code, kDone);
  std::string text = testing::read_bytes(arm);
  const std::size_t tip = text.find("a_mm = ", text.find("[tip]"));
  text.replace(tip, text.find('\n', tip) - tip, "a_mm = 30.0");
  const auto result = tool(
      {"probe", folder.write("wrong.arm.toml", text), folder.write("seat.csv", rows), "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json parameters = result.json()["parameters"];
  for (const auto& parameter : parameters) {
    if (parameter["name"] != "a7") continue;
    EXPECT_NEAR(parameter["value"].get<double>(), 40.7495, 0.03);
  }
}

}  // namespace
}  // namespace armcal::cli
