// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/path_reference.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace armcal {
namespace {

TEST(PathReference, StartsInTheFolderOfTheFileThatNamesIt) {
  EXPECT_EQ(resolved_path("folder/a.session.toml", "../arms/b.arm.toml"), "arms/b.arm.toml");
  EXPECT_EQ(resolved_path("a.session.toml", "b.csv"), "b.csv");
  EXPECT_EQ(resolved_path("folder/a.session.toml", "/b.csv"), "/b.csv");
  EXPECT_EQ(resolved_path("folder/a.session.toml", "-"), "-");
}

TEST(PathReference, LeadsBackToThePathThatItWasMadeFrom) {
  for (const char* file : {"a.toml", "one/a.toml", "one/two/a.toml", "../a.toml"}) {
    for (const char* path : {"b.csv", "one/b.csv", "three/b.csv", "/tmp/b.csv", "-"}) {
      const std::string written = relative_path(file, path);
      if (std::string(file) == "../a.toml" && written[0] == '/') continue;  // see below
      EXPECT_EQ(resolved_path(file, written), path) << file;
    }
  }
}

TEST(PathReference, IsAbsoluteWhereTheWayBackIsUnknown) {
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(relative_path("/tmp/a.toml", "b.csv"), here + "/b.csv");
  EXPECT_EQ(relative_path("../a.toml", "b.csv"), here + "/b.csv");
}

}  // namespace
}  // namespace armcal
