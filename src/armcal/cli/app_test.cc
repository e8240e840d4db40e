// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/app.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/cli/command.h"
#include "armcal/cli/commands.h"
#include "armcal/core/invariant.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::TemporaryFolder;
using testing::tool;

TEST(App, WithoutArgumentsShowsWhatItCan) {
  const auto result = tool({});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err, HasSubstr("Usage: armcal COMMAND"));
}

TEST(App, HelpAndVersionGoToStandardOutput) {
  EXPECT_THAT(tool({"--help"}).out, HasSubstr("symmetric-point"));
  EXPECT_EQ(tool({"--help"}).code, kDone);
  EXPECT_THAT(tool({"--version"}).out, HasSubstr("armcal 0."));
}

// Help of every verb names its arguments and shows examples.
void expect_good_help(const Command& command, const std::vector<std::string>& path) {
  std::vector<std::string> arguments = path;
  arguments.push_back("--help");
  const auto result = tool(arguments);
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.out, HasSubstr("Usage: armcal"));
  for (const Argument& argument : command.arguments) {
    EXPECT_THAT(result.out, HasSubstr(argument.spellings().back())) << command.name;
    EXPECT_FALSE(argument.help.empty());
  }
  if (command.subcommands.empty()) {
    EXPECT_GE(command.examples.size(), 1u) << command.name;
    EXPECT_THAT(result.out, HasSubstr("Examples"));
  }
  for (const Command& verb : command.subcommands) {
    std::vector<std::string> longer = path;
    longer.push_back(verb.name);
    expect_good_help(verb, longer);
  }
}

TEST(App, EveryVerbHasHelpWithExamples) {
  for (const Command& command : all_commands()) expect_good_help(command, {command.name});
}

TEST(App, MistypedVerbsAndOptionsGetAProposal) {
  EXPECT_THAT(tool({"ftt"}).err,
              HasSubstr("unknown command \"ftt\"\n  help: did you mean \"fit\"?"));
  EXPECT_THAT(tool({"register", "a", "b", "--scael"}).err,
              HasSubstr("unknown option --scael\n  help: did you mean \"--scale\"?"));
  EXPECT_THAT(tool({"fit", "circl", "x.csv"}).err,
              HasSubstr("ELEMENT: \"circl\" is none of circle, sphere, plane, line; "
                        "did you mean \"circle\"?"));
  for (const auto& line : std::vector<std::vector<std::string>>{{"ftt"},
                                                                {"register", "--scael"},
                                                                {"fk"},
                                                                {"fk", "a", "b", "c"},
                                                                {"verify"},
                                                                {"verify", "sphere", "x"}}) {
    EXPECT_EQ(tool(line).code, kWrongInput);
  }
}

TEST(App, SaysWhatIsMissingOrNoNumber) {
  EXPECT_THAT(tool({"fk"}).err, HasSubstr("ARM is missing"));
  EXPECT_THAT(tool({"fk", "a", "b", "c"}).err, HasSubstr("too many arguments: c"));
  EXPECT_THAT(tool({"verify"}).err, HasSubstr("a command is missing\n  help: known: sphere"));
  EXPECT_THAT(tool({"verify", "sphere", "x"}).err, HasSubstr("--diameter MM must be given"));
  EXPECT_THAT(tool({"verify", "sphere", "x", "--diameter", "big"}).err,
              HasSubstr("--diameter \"big\" is not a number"));
  EXPECT_THAT(tool({"fk", "a", "b", "--map", "q1_deg"}).err,
              HasSubstr("--map q1_deg: expected OURS=THEIRS"));
}

TEST(App, JsonModeTellsErrorsAsJsonToo) {
  const auto missing = tool({"fit", "sphere", "no-such.csv", "--json"});
  EXPECT_EQ(missing.code, kWrongInput);
  EXPECT_THAT(missing.err, HasSubstr("no-such.csv: error: cannot open"));
  const auto json = missing.json();
  EXPECT_EQ(json["error"]["exit_code"], 2);
  EXPECT_EQ(json["error"]["problems"][0]["file"], "no-such.csv");
  EXPECT_EQ(tool({"ftt", "--json"}).json()["error"]["exit_code"], 2);
}

TEST(App, ColorsOnlyWhenAsked) {
  EXPECT_THAT(tool({"ftt"}).err, Not(HasSubstr("\x1b[")));
  EXPECT_THAT(tool({"fit", "sphere", "no-such.csv", "--color", "always"}).err,
              HasSubstr("\x1b[1;31merror:\x1b[0m"));
}

TEST(App, QuietKeepsWarningsBack) {
  const TemporaryFolder folder;
  const std::string points = folder.write("p.csv", "1 2\n4 5\n7 9\n");
  EXPECT_THAT(tool({"fit", "circle", points}).err, HasSubstr("warning: has no header"));
  EXPECT_THAT(tool({"fit", "circle", points, "--quiet"}).err, IsEmpty());
}

TEST(App, GivesDevicesThatFailCode5) {
  const TemporaryFolder folder;
  const std::string arm = testing::example("arms/ur10.arm.toml");
  const std::string angles = testing::example("angles/six-joints.csv");
  const auto full = tool({"fk", arm, angles, "-o", "/dev/full"});
  EXPECT_EQ(full.code, kDeviceFailure);
  EXPECT_THAT(full.err, HasSubstr("/dev/full: cannot write: No space left on device"));
  EXPECT_EQ(tool({"fk", arm, angles, "-o", "/no/such/folder/x.csv"}).code, kDeviceFailure);
}

// The work was done, and then lost.
TEST(App, WantsTheFolderOfEveryOutputBeforeTheWorkBegins) {
  const TemporaryFolder folder;
  const std::string arm = testing::example("arms/ur10.arm.toml");
  const std::string none = folder.path("none.csv");  // would be complained of, were it read
  for (const auto& line :
       std::vector<std::vector<std::string>>{{"calibrate", none, "-o"},
                                             {"calibrate", none, "--save"},
                                             {"calibrate", none, "--report"},
                                             {"calibrate", none, "--pdf"},
                                             {"fk", arm, none, "-o"},
                                             {"predict", none, none, "-o"},
                                             {"convert", none, "--to", "urdf", "-o"},
                                             {"symmetric-point", none, "-o"},
                                             {"compare", "--markdown"},
                                             {"plan", "symmetric-point", none, "-o"},
                                             {"plan", "symmetric-point", none, "--worksheet"},
                                             {"plan", "verification", none, "--picture"},
                                             {"check", none, "--length", "400", "--history"},
                                             {"check", "--history", none, "--export"},
                                             {"report", none, "-o"},
                                             {"report", none, "--pdf"},
                                             {"report", none, "--extract", "-o"},
                                             {"demo", "--report"}}) {
    std::vector<std::string> words = line;
    words.push_back(folder.path("missing/x"));
    const auto result = tool(words);
    EXPECT_EQ(result.code, kDeviceFailure) << ::testing::PrintToString(words) << result.err;
    EXPECT_THAT(result.err, HasSubstr("/missing/x: the folder " + folder.path("missing") +
                                      " does not exist\n  help: make it first: mkdir -p "));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("missing")));
}

// The page of exit codes once promised 5 for these.
TEST(App, GivesMissingInputAndExistingOutputCode2) {
  const TemporaryFolder folder;
  const std::string arm = testing::example("arms/ur10.arm.toml");
  const std::string angles = testing::example("angles/six-joints.csv");
  EXPECT_EQ(tool({"fk", folder.path("none.arm.toml"), angles}).code, kWrongInput);
  EXPECT_EQ(tool({"fk", arm, folder.path("")}).code, kWrongInput);  // a folder
  const std::string precious = folder.write("tips.csv", "precious");
  EXPECT_EQ(tool({"fk", arm, angles, "-o", precious}).code, kWrongInput);
  EXPECT_EQ(testing::read_bytes(precious), "precious");
}

TEST(AppDeathTest, GivesABugCode70AndAsksToReportIt) {
  EXPECT_EXIT(
      {
        end_with_exit_code_on_abort();
        ARMCAL_INVARIANT(1 + 1 == 3);
      },
      ::testing::ExitedWithCode(kBug), "please report it with the command and the files");
}

// With --force an output took the place of the readings it was computed from.
TEST(App, NeverOverwritesAnInput) {
  const TemporaryFolder folder;
  const std::string arm =
      folder.write("a.arm.toml", testing::read_bytes(testing::example("arms/ur10.arm.toml")));
  const std::string angles =
      folder.write("q.csv", testing::read_bytes(testing::example("angles/six-joints.csv")));
  const std::string before = testing::read_bytes(angles);
  const auto result = tool({"fk", arm, angles, "--force", "-o", folder.path("./q.csv")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("is an input of this very command"));
  EXPECT_EQ(testing::read_bytes(angles), before);
  EXPECT_EQ(tool({"convert", arm, "--to", "dh-classic", "--force", "-o", arm}).code, kWrongInput);
}

TEST(App, RefusesNumbersThatNoMeasurementHas) {
  const std::string sphere = testing::example("points/sphere.csv");
  const auto complaint = [&](const std::vector<std::string>& more) {
    std::vector<std::string> line = {"verify", "sphere", sphere, "--diameter", "25.4"};
    line.insert(line.end(), more.begin(), more.end());
    const auto result = tool(line);
    EXPECT_EQ(result.code, kWrongInput) << result.out;
    return result.err;
  };
  EXPECT_THAT(complaint({"--limit", "nan"}), HasSubstr("--limit nan: must be a finite number"));
  EXPECT_THAT(complaint({"--limit", "-1"}), HasSubstr("--limit -1: must be larger than 0"));
  EXPECT_THAT(complaint({"--form-limit", "inf"}), HasSubstr("--form-limit inf: must be a finite"));
  EXPECT_THAT(complaint({"--tip-diameter", "-2"}), HasSubstr("must not be negative"));
  // Larger than the fitted sphere: a negative diameter used to be printed.
  EXPECT_THAT(complaint({"--tip-diameter", "30"}), HasSubstr("tip diameter 30 mm: leaves nothing"));
  const std::string points = testing::example("points/frame-a.csv");
  for (const char* u : {"inf", "0", "-0.1"}) {
    EXPECT_EQ(tool({"fit", "plane", points, "--u", u}).code, kWrongInput) << u;
    EXPECT_EQ(tool({"register", points, points, "--u", u}).code, kWrongInput) << u;
  }
}

TEST(App, NamesTheOptionThatIsNone) {
  const std::string points = testing::example("points/frame-a.csv");
  EXPECT_THAT(tool({"fit", "plane", points, "-o", "x.txt"}).err, HasSubstr("unknown option -o"));
  EXPECT_THAT(tool({"register", points, points, "--scale=2"}).err,
              HasSubstr("--scale takes no value"));
  EXPECT_THAT(tool({"fit", "line", points, "--plane-first"}).err,
              HasSubstr("--plane-first is for circles"));
}

TEST(App, StopsWhenInterrupted) {
  const TemporaryFolder folder;
  const std::string output = folder.path("tips.csv");
  std::stop_source source;
  source.request_stop();
  const auto result = tool({"fk", testing::example("arms/ur10.arm.toml"),
                            testing::example("angles/six-joints.csv"), "-o", output},
                           source.get_token());
  EXPECT_EQ(result.code, kInterrupted);
  EXPECT_FALSE(std::filesystem::exists(output));
}

}  // namespace
}  // namespace armcal::cli
