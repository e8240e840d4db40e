// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/input_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

TEST(InputFiles, RemembersWhatWasRead) {
  const testing::TemporaryFolder folder;
  InputFiles files;
  const auto points = files.points(folder.write("p.csv", "x_mm,y_mm\n1,2\n"), {});
  ASSERT_TRUE(points.has_value());
  files.require_good();
  ASSERT_EQ(files.records().size(), 1u);
  EXPECT_EQ(files.records()[0].sha256.size(), 64u);
}

TEST(InputFiles, TellsTheProblemsOfAllFilesTogether) {
  const testing::TemporaryFolder folder;
  InputFiles files;
  EXPECT_FALSE(
      files.arm(folder.write("a.arm.toml", "schema = 'armcal.arm/1'\nlnk = 1\n")).has_value());
  EXPECT_FALSE(files.points(folder.path("missing.csv"), {}).has_value());
  try {
    files.require_good();
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown key \"lnk\""));
    EXPECT_THAT(error.what(), HasSubstr("missing.csv: error: cannot open"));
  }
}

TEST(InputFiles, ReadsTheBuiltInExamples) {
  InputFiles files({}, FileSource::embedded);
  EXPECT_TRUE(files.arm("examples/arms/romer-infinite-2.0.arm.toml").has_value());
  EXPECT_FALSE(files.arm("examples/none.arm.toml").has_value());
  EXPECT_THROW(files.require_good(), InputError);
}

}  // namespace
}  // namespace armcal
