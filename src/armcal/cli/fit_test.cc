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

TEST(FitCommand, CircleTakesTwoOrThreeCoordinates) {
  const auto planar = tool({"fit", "circle", example("points/gander1994.csv"), "--json"});
  EXPECT_EQ(planar.code, kDone);
  EXPECT_NEAR(planar.json()["radius_mm"].get<double>(), 4.714226, 5e-7);
  EXPECT_NEAR(planar.json()["center_mm"][0].get<double>(), 4.739782, 5e-7);
  const TemporaryFolder folder;
  const auto spatial = tool(
      {"fit", "circle", folder.write("c.csv", "x_mm,y_mm,z_mm\n1,0,5\n0,1,5\n-1,0,5\n"), "--json"});
  EXPECT_NEAR(spatial.json()["radius_mm"].get<double>(), 1.0, 1e-14);
  EXPECT_EQ(spatial.json()["status"], "converged");
}

TEST(FitCommand, FitsEveryElement) {
  for (const char* element : {"circle", "sphere", "plane", "line"}) {
    const char* points = element == std::string("circle") ? "points/arc.csv" : "points/sphere.csv";
    const auto result = tool({"fit", element, example(points)});
    EXPECT_EQ(result.code, kDone) << result.err;
    EXPECT_THAT(result.out, HasSubstr(std::string("Least-squares ") + element));
  }
  EXPECT_EQ(tool({"fit", "circle", example("points/arc.csv"), "--plane-first"}).code, kDone);
}

TEST(FitCommand, StatedUncertaintyGivesACovariance) {
  const TemporaryFolder folder;
  const std::string points = folder.write("p.csv", "x_mm,y_mm,z_mm\n0,0,1\n1,0,0\n0,1,0\n");
  EXPECT_TRUE(tool({"fit", "plane", points, "--json"}).json()["covariance"].is_null());
  EXPECT_TRUE(
      tool({"fit", "plane", points, "--json", "--u", "0.01"}).json()["covariance"].is_array());
  EXPECT_EQ(tool({"fit", "plane", points, "--u", "-1"}).code, kWrongInput);
}

TEST(FitCommand, RefusesDegeneratePointsWithCode4) {
  const TemporaryFolder folder;
  const std::string flat =
      folder.write("flat.csv", "x_mm,y_mm,z_mm\n0,0,5\n1,0,5\n0,1,5\n3,2,5\n1,1,5\n");
  const std::string line = folder.write("line.csv", "x_mm,y_mm,z_mm\n0,0,1\n1,1,2\n2,2,3\n");
  const auto sphere = tool({"fit", "sphere", flat});
  EXPECT_EQ(sphere.code, kNumericalFailure);
  EXPECT_THAT(sphere.err, HasSubstr("flat.csv: no sphere fits: the points lie in one plane"));
  EXPECT_THAT(tool({"fit", "circle", line}).err, HasSubstr("the points lie on one line"));
  EXPECT_EQ(tool({"fit", "plane", line}).code, kNumericalFailure);
  EXPECT_THAT(tool({"fit", "line", folder.write("one.csv", "x_mm,y_mm,z_mm\n1,2,3\n")}).err,
              HasSubstr("there are too few points"));
}

TEST(FitCommand, RefusesDuplicatesAndMissingPoints) {
  const TemporaryFolder folder;
  const auto result =
      tool({"fit", "sphere",
            folder.write("p.csv", "x_mm,y_mm,z_mm\n1,2,3\n1,2,3\n0,0,0\n4,5,6\n7,8,8\n")});
  EXPECT_EQ(result.code, kWrongInput);
  EXPECT_THAT(result.err, HasSubstr("p.csv:3: error: repeats the point of line 2"));
  EXPECT_THAT(result.err, HasSubstr("p.csv:4: error: the point 0 0 0 looks like a missing one"));
}

}  // namespace
}  // namespace armcal::cli
