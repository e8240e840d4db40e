// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/embedded_files.h"

#include <gtest/gtest.h>

#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"

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

}  // namespace
}  // namespace armcal
