// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/registration_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

std::string complaint_about_points(const std::string& first, const std::string& second,
                                   const TableOptions& options = {}) {
  const TemporaryFolder folder;
  InputFiles files;
  try {
    static_cast<void>(read_point_pairs(files, folder.write("a.csv", first),
                                       folder.write("b.csv", second), options));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// Names were ignored, and tables of another order gave a wrong transform without a word.
TEST(PointPairs, ArePairedByNameWhereBothTablesHaveNames) {
  const TemporaryFolder folder;
  InputFiles files;
  const PointPairs pairs = read_point_pairs(
      files, folder.write("a.csv", "point,x_mm,y_mm,z_mm\np,1,0,0\nq,2,0,0\nr,3,0,0\n"),
      folder.write("b.csv", "x_mm,y_mm,z_mm,point\n30,0,0,r\n10,0,0,p\n20,0,0,q\n"), {});
  EXPECT_TRUE(pairs.by_name);
  ASSERT_EQ(pairs.second_mm.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pairs.second_mm[i].x(), 10.0 * pairs.first_mm[i].x());
  }
}

TEST(PointPairs, NamesThatDoNotMatchAreListed) {
  const std::string text =
      complaint_about_points("point,x_mm,y_mm,z_mm\np,1,0,0\nq,2,0,0\nr,3,0,0\n",
                             "point,x_mm,y_mm,z_mm\np,1,0,0\np,2,0,0\ns,3,0,0\n");
  EXPECT_THAT(text, HasSubstr("b.csv:3: error: point \"p\" is already on line 2"));
  EXPECT_THAT(text, HasSubstr("b.csv: error: has no points q, r of "));
  EXPECT_THAT(text, HasSubstr("a.csv: error: has no point s of "));
}

TEST(PointPairs, OneMapServesTheFileThatHasTheColumn) {
  TableOptions options;
  options.map = {{"x_mm", "X"}, {"y_mm", "Y"}, {"z_mm", "Z"}};
  const TemporaryFolder folder;
  InputFiles files;
  const PointPairs pairs =
      read_point_pairs(files, folder.write("a.csv", "X,Y,Z\n1,2,3\n4,5,6\n7,8,10\n"),
                       folder.write("b.csv", "x_mm,y_mm,z_mm\n1,2,3\n4,5,6\n7,8,10\n"), options);
  EXPECT_FALSE(pairs.by_name);
  EXPECT_EQ(pairs.first_mm, pairs.second_mm);
  options.map = {{"x_mm", "Xx"}};
  EXPECT_THAT(complaint_about_points("x_mm,y_mm,z_mm\n1,2,3\n", "x_mm,y_mm,z_mm\n1,2,3\n", options),
              HasSubstr("--map x_mm=Xx: no column \"Xx\", and none in "));
}

}  // namespace
}  // namespace armcal
