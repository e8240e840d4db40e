// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/forward_kinematics_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;

constexpr const char* kArm =
    "schema = 'armcal.arm/1'\n[[link]]\na_mm = 100\n[tip]\na_mm = 50\n[[joint]]\nmin_deg = "
    "-90\nmax_deg = 90\n[[joint]]\n";

TEST(ForwardKinematicsJob, ComputesATipForEveryRow) {
  const testing::TemporaryFolder folder;
  InputFiles files;
  const auto tips = compute_tips(files, folder.write("a.arm.toml", kArm),
                                 folder.write("q.csv", "q1_deg,q2_deg\n0,0\n90,90\n"), {});
  ASSERT_EQ(tips.cols(), 2);
  EXPECT_NEAR((tips.col(0) - Eigen::Vector3d(150, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((tips.col(1) - Eigen::Vector3d(-50, 100, 0)).norm(), 0, 1e-12);
  EXPECT_FALSE(files.diagnostics().has_errors());
}

TEST(ForwardKinematicsJob, WarnsOfReadingsOutsideTheLimits) {
  const testing::TemporaryFolder folder;
  InputFiles files;
  static_cast<void>(compute_tips(files, folder.write("a.arm.toml", kArm),
                                 folder.write("q.csv", "q1_deg,q2_deg\n0,0\n95,0\n100,0\n"), {}));
  EXPECT_THAT(
      files.diagnostics().to_text(),
      HasSubstr(
          "q.csv:3: warning: joint 1 reads 95.000 deg, outside its limits (so do 1 more rows)"));
}

TEST(ForwardKinematicsJob, CsvReadsBackTheSame) {
  Eigen::Matrix3Xd tips(3, 1);
  tips << 0.1, -1e-17, 12345.678901234567;
  EXPECT_EQ(tips_csv(tips), "x_mm,y_mm,z_mm\n0.1,0,12345.678901235\n");
}

}  // namespace
}  // namespace armcal
