// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/embedded_files.h"

#include <gtest/gtest.h>

#include "armcal/arm/parameter_table.h"
#include "armcal/simulation/measuring_arms.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/workflow/input_files.h"

namespace armcal {
namespace {

TEST(EmbeddedFiles, AreTheFilesOfTheRepository) {
  EXPECT_GE(embedded_files().size(), 5u);
  for (const EmbeddedFile& file : embedded_files()) {
    EXPECT_EQ(file.text, testing::read_bytes(testing::repository() / file.path)) << file.path;
  }
}

TEST(EmbeddedFiles, AreFoundByPath) {
  EXPECT_TRUE(find_embedded_file("examples/wang2016/nominal.arm.toml").has_value());
  EXPECT_FALSE(find_embedded_file("no/such/file").has_value());
}

TEST(EmbeddedFiles, DescribeTheArmsThatScenariosDraw) {
  const std::pair<const char*, ArmModel> pairs[] = {
      {"examples/wang2016/nominal.arm.toml", romer_arm()},
      {"examples/arms/seven-joint.arm.toml", seven_joint_arm()}};
  for (const auto& [path, drawn] : pairs) {
    InputFiles files({}, FileSource::embedded);
    const auto arm = files.arm(path);
    ASSERT_TRUE(arm.has_value()) << path;
    EXPECT_LT((parameter_values(*arm) - parameter_values(drawn)).norm(), 1e-12) << path;
    for (std::size_t i = 0; i < drawn.joints.size(); ++i) {
      EXPECT_EQ(arm->joints[i].min_rad, drawn.joints[i].min_rad) << path;
      EXPECT_EQ(arm->joints[i].max_rad, drawn.joints[i].max_rad) << path;
    }
  }
}

}  // namespace
}  // namespace armcal
