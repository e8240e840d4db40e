// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "armcal/cli/command.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

namespace armcal::cli {
namespace {

using ::testing::HasSubstr;
using testing::tool;
using testing::ToolResult;

TEST(DemoCommand, TellsThePapersStory) {
  const auto result = tool({"demo"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_THAT(result.out, HasSubstr("104.700 agrees with both"));
  EXPECT_EQ(tool({"demo", "paper"}).out, result.out);
  EXPECT_NEAR(tool({"demo", "paper", "--json"}).json()["sphere"]["relative_error"].get<double>(),
              -0.003836, 5e-7);
  EXPECT_EQ(tool({"demo", "nonsense"}).code, kWrongInput);
}

TEST(DemoCommand, TellsTheStoryOfAVirtualArm) {
  const auto result = tool({"demo", "virtual", "--json"});
  ASSERT_EQ(result.code, kDone) << result.err;
  const Json json = result.json();
  EXPECT_EQ(json["seed"], 1);
  ASSERT_EQ(json["calibrations"].size(), 3u);
  const Json& cone = json["calibrations"][0];
  const Json& kit = json["calibrations"][1];
  const Json& cmm = json["calibrations"][2];
  // The truth is the best there is; what knows the scale comes near it, what does not stays far.
  EXPECT_GT(json["drawing"]["ratio_to_floor"], 10.0);
  for (const Json& good : {kit, cmm}) {
    EXPECT_GT(good["ratio_to_floor"], 0.98);
    EXPECT_LT(good["ratio_to_floor"], 1.5);
    EXPECT_LT(std::abs(good["scale_um_per_m"].get<double>()), 20.0);
    EXPECT_GE(good["intervals"]["inside"].get<int>(), good["intervals"]["count"].get<int>() - 4);
    EXPECT_NEAR(good["sigma0"].get<double>(), 1.0, 0.2);
  }
  EXPECT_GT(std::abs(cone["scale_um_per_m"].get<double>()), 50.0);
  // An arm that is larger by one in a thousand reads the cone with as much more scatter.
  const Json& blind = json["cone"];
  EXPECT_NEAR(blind["rms_mm_of_grown_arm"].get<double>(), 1.001 * blind["rms_mm"].get<double>(),
              1e-9);
  EXPECT_THAT(tool({"demo", "virtual"}).out, HasSubstr("armcal calibrate refuses the cone alone"));
}

class DemoReport : public ::testing::Test {
 protected:
  DemoReport() { setenv("TMPDIR", folder_.path("").c_str(), 1); }
  ~DemoReport() override { unsetenv("TMPDIR"); }

  [[nodiscard]] std::string page() const {
    return folder_.path("armcal-demo-" + std::to_string(getuid()) + "/paper.html");
  }
  testing::TemporaryFolder folder_;
};

TEST_F(DemoReport, EndsTheTextWithItsPathAndIsMadeAnewEachTime) {
  for (int run = 0; run < 2; ++run) {
    const ToolResult result = tool({"demo"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_THAT(result.out, ::testing::EndsWith("\nReport: " + page() + "\n"));
    EXPECT_THAT(testing::read_bytes(page()), HasSubstr("The 2016 paper, recomputed"));
  }
}

TEST_F(DemoReport, GoesWhereItIsAskedFor) {
  const std::string html = folder_.path("mine.html");
  const ToolResult result = tool({"demo", "--report", html});
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, ::testing::Not(HasSubstr("Report: ")));
  EXPECT_TRUE(std::filesystem::exists(html));
  EXPECT_FALSE(std::filesystem::exists(page()));
  EXPECT_EQ(tool({"demo", "--report", html}).code, 2);  // not overwritten
}

TEST_F(DemoReport, IsNotPutIntoAFolderOfSomebodyElse) {
  const std::string folder = std::filesystem::path(page()).parent_path().string();
  std::filesystem::create_directory(folder);
  std::filesystem::permissions(folder, std::filesystem::perms::all);
  const ToolResult result = tool({"demo"});
  EXPECT_EQ(result.code, 5);
  EXPECT_THAT(result.err, HasSubstr("is not a folder of yours alone: say --report FILE"));
}

}  // namespace
}  // namespace armcal::cli
