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

TEST(RegisterCommand, FindsTheTransform) {
  const auto result =
      tool({"register", example("points/frame-a.csv"), example("points/frame-b.csv"), "--json"});
  EXPECT_EQ(result.code, kDone);
  EXPECT_NEAR(result.json()["translation_mm"][0].get<double>(), 1200.0, 0.02);
  EXPECT_EQ(result.json()["scale"], 1.0);
  EXPECT_LT(result.json()["rms_mm"].get<double>(), 0.03);
  const auto scaled = tool({"register", example("points/frame-a.csv"),
                            example("points/frame-b.csv"), "--scale", "--json"});
  EXPECT_NEAR(scaled.json()["scale"].get<double>(), 1.0, 1e-4);
  EXPECT_NE(scaled.json()["scale"], 1.0);
}

TEST(RegisterCommand, AsksWhetherAnAxisIsReversed) {
  const TemporaryFolder folder;
  const std::string one =
      folder.write("one.csv", "x_mm,y_mm,z_mm\n100,0,0\n0,120,0\n0,0,90\n30,40,20\n-50,10,60\n");
  const std::string mirrored =
      folder.write("two.csv", "x_mm,y_mm,z_mm\n100,0,0\n0,120,0\n0,0,-90\n30,40,-20\n-50,10,-60\n");
  EXPECT_THAT(tool({"register", one, mirrored}).err,
              HasSubstr("the points look mirrored: is one axis reversed"));
  EXPECT_THAT(tool({"register", one, one}).err, ::testing::IsEmpty());
}

TEST(RegisterCommand, RefusesPairsThatAreNone) {
  const TemporaryFolder folder;
  const std::string three = folder.write("three.csv", "x_mm,y_mm,z_mm\n1,0,0\n0,1,0\n0,0,1\n");
  const std::string two = folder.write("two.csv", "x_mm,y_mm,z_mm\n1,0,0\n0,1,0\n");
  const std::string line = folder.write("line.csv", "x_mm,y_mm,z_mm\n1,0,0\n2,0,0\n3,0,0\n");
  EXPECT_THAT(tool({"register", three, two}).err, HasSubstr("two.csv: error: has 2 points"));
  EXPECT_EQ(tool({"register", three, two}).code, kWrongInput);
  EXPECT_EQ(tool({"register", three, line}).code, kNumericalFailure);
}

}  // namespace
}  // namespace armcal::cli
