// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>

#include "armcal/cli/command.h"
#include "armcal/core/random.h"
#include "armcal/io/check_history.h"
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

const std::string kCheckedArm = example("arms/seven-joint.arm.toml");

std::string week(int number) { return example(fmt::format("check/week-{:02}.csv", number)); }

std::vector<std::string> check(const std::string& readings,
                               const std::vector<std::string>& more = {}) {
  std::vector<std::string> line = {"check", readings, "--arm", kCheckedArm, "--length", "400"};
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

std::vector<std::string> saved(int number, const std::string& history,
                               const std::vector<std::string>& more = {}) {
  std::vector<std::string> line =
      check(week(number), {"--history", history, "--time", fmt::format("2026-01-{:02}", number)});
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

double value_of(const Json& json, const std::string& name) {
  for (const Json& test : json["tests"]) {
    if (test["name"] == name) return test["value_mm"];
  }
  ADD_FAILURE() << "no " << name;
  return NAN;
}

// Points of a table by their name, as `fk` has them.
TEST(CheckCommand, AgreesWithAComputationOfItsOwn) {
  const TemporaryFolder folder;
  const Json tips = tool({"fk", kCheckedArm, week(9), "--json"}).json()["tips_mm"];
  ASSERT_EQ(tips.size(), 20u);
  std::string rows = "point,x_mm,y_mm,z_mm\n";
  double means[2][3] = {};
  for (std::size_t i = 0; i < 20; ++i) {
    const Json& tip = tips[i];
    rows += fmt::format("{},{},{},{}\n", i < 10 ? "A" : "B", tip[0].get<double>(),
                        tip[1].get<double>(), tip[2].get<double>());
    for (std::size_t k = 0; k < 3; ++k) means[i / 10][k] += tip[k].get<double>() / 10.0;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < 20; ++i) {
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      square += std::pow(tips[i][k].get<double>() - means[i / 10][k], 2);
    largest = std::max(largest, std::sqrt(square));
  }
  const double length =
      std::hypot(means[1][0] - means[0][0], means[1][1] - means[0][1], means[1][2] - means[0][2]);
  const auto by_angles = tool(check(week(9), {"--json"}));
  const auto by_points =
      tool({"check", folder.write("points.csv", rows), "--length", "400", "--json"});
  for (const auto& result : {by_angles, by_points}) {
    ASSERT_EQ(result.code, kDone) << result.err;
    EXPECT_NEAR(value_of(result.json(), "max_deviation"), largest, 1e-9);
    EXPECT_NEAR(value_of(result.json(), "length_error"), length - 400.0, 1e-9);
    EXPECT_EQ(result.json()["verdict"], "not_judged");
  }
}

TEST(CheckCommand, ChecksASphere) {
  const auto result =
      tool({"check", example("sphere/five-articulations.csv"), "--arm",
            example("arms/romer-infinite-2.0.arm.toml"), "--diameter", "15.8754", "--tip-diameter",
            "6", "--limit", "0.02", "--form-limit", "0.01", "--json"});
  EXPECT_EQ(result.code, kDoesNotConform) << result.err;
  EXPECT_EQ(result.json()["kind"], "sphere");
  EXPECT_EQ(result.json()["tests"][0]["verdict"], "pass");
  EXPECT_EQ(result.json()["tests"][1]["verdict"], "fail");
}

TEST(CheckCommand, EndsWith1WhereALimitIsExceeded) {
  EXPECT_EQ(tool(check(week(1), {"--limit", "0.05", "--length-limit", "0.05"})).code, kDone);
  EXPECT_EQ(tool(check(week(12), {"--limit", "0.05"})).code, kDoesNotConform);
  EXPECT_EQ(tool(check(week(12), {"--limit", "0.2", "--length-limit", "0.001"})).code,
            kDoesNotConform);
}

TEST(CheckCommand, KeepsAHistoryAndTellsOfItsTrend) {
  const TemporaryFolder folder;
  const std::string history = folder.path("checks.db");
  testing::ToolResult last;
  for (int number = 1; number <= 12; ++number) {
    last = tool(saved(number, history, {"--limit", "0.2", "--baseline", "8", "--json"}));
    ASSERT_EQ(last.code, kDone) << last.err;
    EXPECT_EQ(last.json()["saved_as"], number);
  }
  // The arm drifts from week 9 on; a warning, and still exit code 0.
  EXPECT_THAT(last.err, HasSubstr("largest deviation: 1 check more than 3 sigma above the centre "
                                  "line (rule 1)"));
  EXPECT_THAT(last.err, HasSubstr("drifts by +"));
  EXPECT_EQ(last.json()["trends"][0]["checks"].size(), 12u);

  const auto look = tool({"check", "--history", history, "--baseline", "8"});
  EXPECT_EQ(look.code, kDone) << look.err;
  EXPECT_THAT(look.out, HasSubstr("Trend of the largest deviation: 12 checks of seven-joint"));
  EXPECT_THAT(look.out, HasSubstr("check 12: 1 check more than 3 sigma above"));
}

TEST(CheckCommand, ExportsItsHistory) {
  const TemporaryFolder folder;
  const std::string history = folder.path("checks.db");
  const std::string table = folder.path("checks.csv");
  ASSERT_EQ(tool(saved(1, history, {"--note", "after the move, new table"})).code, kDone);
  ASSERT_EQ(tool(saved(2, history, {"--temperature", "20.5", "--export", table})).code, kDone);
  const std::string text = testing::read_bytes(table);
  EXPECT_THAT(text,
              HasSubstr("check,time_utc,arm,artefact,kind,points,temperature_c,verdict,max_"));
  EXPECT_THAT(text, HasSubstr("\n1,2026-01-01T00:00:00Z,seven-joint measuring arm,,seat,20,,not_"));
  EXPECT_THAT(text, HasSubstr("\"after the move, new table\""));
  EXPECT_THAT(text, HasSubstr(",20.5,"));
  EXPECT_EQ(tool({"check", "--history", history, "--export", table}).code,
            kWrongInput);  // is there
  EXPECT_EQ(tool({"check", "--history", history, "--export", history, "--force"}).code,
            kWrongInput);  // never over the history
}

TEST(CheckCommand, SavesReadingsOnce) {
  const TemporaryFolder folder;
  const std::string history = folder.path("checks.db");
  ASSERT_EQ(tool(saved(1, history)).code, kDone);
  const auto again = tool(saved(1, history));
  EXPECT_EQ(again.code, kWrongInput);
  EXPECT_THAT(again.err, HasSubstr("these readings are check 1 of"));
  // With another limit it is another judgement.
  EXPECT_EQ(tool(saved(1, history, {"--limit", "0.2"})).code, kDone);
}

TEST(CheckCommand, WarnsOfAnotherArmAndOfAnotherArmFile) {
  const TemporaryFolder folder;
  const std::string history = folder.path("checks.db");
  ASSERT_EQ(tool(saved(1, history)).code, kDone);
  const auto stranger = tool(saved(2, history, {"--arm-name", "4711"}));
  EXPECT_EQ(stranger.code, kDone);
  EXPECT_THAT(stranger.err, HasSubstr("holds checks of seven-joint measuring arm so far, and none "
                                      "of \"4711\""));
  auto line = saved(3, history);
  line[3] =
      folder.write("new.arm.toml", testing::read_bytes(kCheckedArm) + "\n# calibrated anew\n");
  const auto calibrated = tool(line);
  EXPECT_EQ(calibrated.code, kDone) << calibrated.err;
  EXPECT_THAT(calibrated.err, HasSubstr("a new chart begins"));
  const auto look = tool({"check", "--history", history, "--arm-name", "4711", "--json"});
  EXPECT_EQ(look.json()["arm_name"], "4711");
  EXPECT_EQ(look.json()["trends"][0]["checks"].size(), 1u);
  EXPECT_THAT(tool({"check", "--history", history, "--arm-name", "4712"}).err,
              HasSubstr("holds no such check"));
}

TEST(CheckCommand, NamesWhatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_THAT(tool({"check"}).err, HasSubstr("nothing to do"));
  EXPECT_THAT(tool({"check", week(1)}).err, HasSubstr("give the arm that turns them into tips"));
  EXPECT_THAT(tool({"check", week(1), "--arm", kCheckedArm, "--length-limit", "0.1"}).err,
              HasSubstr("a limit of the length error needs the certified length"));
  EXPECT_THAT(tool(check(week(1), {"--time", "yesterday"})).err,
              HasSubstr("--time yesterday: is no time"));
  EXPECT_THAT(tool(check(week(1), {"--export", "x.csv"})).err, HasSubstr("there is no history"));
  const std::string one =
      folder.write("one.csv", "x_mm,y_mm,z_mm\n1,2,3\n1.01,2,3\n1,2.01,3\n1,2,3.01\n");
  const auto length = tool({"check", one, "--length", "400"});
  EXPECT_EQ(length.code, kWrongInput);
  EXPECT_THAT(length.err, HasSubstr("a length lies between 2 seats, the readings are of 1"));
  const auto few = tool({"check", one});
  EXPECT_EQ(few.code, kDone);
  EXPECT_THAT(few.err, HasSubstr("4 points: 10 show more"));
  EXPECT_EQ(tool({"check", "--history", folder.path("none.db")}).code, kWrongInput);
  EXPECT_EQ(tool(saved(1, folder.path("no/such/folder.db"))).code, kDeviceFailure);
  EXPECT_EQ(tool(saved(1, one)).code, kWrongInput);
}

TEST(CheckCommand, WarnsOfJointsThatStoodStill) {
  const auto result = tool({"check", example("sphere/still-wrist.csv"), "--arm",
                            example("arms/romer-infinite-2.0.arm.toml"), "--diameter", "15.8754"});
  EXPECT_THAT(result.err, HasSubstr("joints 1, 2, 3, 4, 5, 6 moved by less than 20 deg"));
}

// Killed at any moment: the history holds every check that the tool has reported as saved.
TEST(CheckCommand, LosesNoReportedCheckWhereItIsKilled) {
  const TemporaryFolder folder;
  const std::string history = folder.path("checks.db");
  RandomStream random(1);
  std::vector<std::int64_t> reported;
  for (int kills = 0; kills < 6; ++kills) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t process = ::fork();
    if (process == 0) {
      for (int again = 0;; ++again) {
        const auto result = tool(check(
            week(1 + again % 12), {"--history", history, "--json", "--note", std::to_string(again),
                                   "--artefact", fmt::format("{}-{}", kills, again)}));
        if (result.code != kDone) ::_exit(1);
        const auto id = result.json()["saved_as"].get<std::int64_t>();
        if (::write(ends[1], &id, sizeof id) != sizeof id) ::_exit(2);
      }
    }
    ::close(ends[1]);
    const auto read_one = [&] {
      std::int64_t id = 0;
      if (::read(ends[0], &id, sizeof id) != sizeof id) return false;
      reported.push_back(id);
      return true;
    };
    for (std::uint64_t wait = random.below(3); wait > 0 && read_one(); --wait) continue;
    ::usleep(static_cast<useconds_t>(random.uniform(0.0, 2e4)));
    ::kill(process, SIGKILL);
    while (read_one()) continue;
    int status = 0;
    ::waitpid(process, &status, 0);
    ::close(ends[0]);
    EXPECT_TRUE(WIFSIGNALED(status));  // it was killed, it did not fail
  }
  ASSERT_FALSE(reported.empty());
  std::vector<std::int64_t> found;
  for (const CheckRecord& each : CheckHistory(history, CheckHistory::Missing::refuse).checks()) {
    found.push_back(each.id);
  }
  for (const std::int64_t id : reported) EXPECT_THAT(found, ::testing::Contains(id));
}

}  // namespace
}  // namespace armcal::cli
