// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

std::string complaint_about_file(const std::string& path, std::uint64_t largest = 1000) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_text_file(path, largest, diagnostics).has_value());
  return diagnostics.to_text();
}

TEST(TextFile, ReadsDecodesAndHashes) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto file = read_text_file(folder.write("a.txt", "abc"), 1000, diagnostics);
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->text, "abc");
  EXPECT_EQ(file->sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(TextFile, SaysWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(complaint_about_file(folder.path("missing.csv")),
              HasSubstr("missing.csv: error: cannot open: No such file or directory"));
  EXPECT_THAT(complaint_about_file(folder.path("")), HasSubstr("error: is a folder, not a file"));
  EXPECT_THAT(complaint_about_file(folder.write("empty.csv", "")),
              HasSubstr("empty.csv: error: is empty"));
  EXPECT_THAT(complaint_about_file(folder.write("big.csv", std::string(1001, 'x'))),
              HasSubstr("is larger than 0 MB"));
  EXPECT_THAT(complaint_about_file(folder.write("bin.csv", std::string("\x7F"
                                                                       "ELF\x02\x01\x00",
                                                                       7))),
              HasSubstr("is not a text file: byte 0x02 at offset 4"));
}

TEST(TextFile, ReportsProgressOfALargeFileAndCanBeStopped) {
  const TemporaryFolder folder;
  const std::string path = folder.write("large.csv", std::string(std::size_t{20} << 20, '1'));
  Diagnostics diagnostics;
  std::stop_source source;
  double last = 0.0;
  const Monitor monitor{[&](const Progress& progress) {
                          last = progress.fraction;
                          if (last > 0.5) source.request_stop();
                        },
                        source.get_token()};
  EXPECT_THROW(static_cast<void>(read_text_file(path, kLargestTable_bytes, diagnostics, monitor)),
               Interrupted);
  EXPECT_GT(last, 0.5);
}

TEST(PathBeside, StartsInTheFolderOfTheFileThatNamesIt) {
  EXPECT_EQ(path_beside("folder/a.session.toml", "../arms/b.arm.toml"), "arms/b.arm.toml");
  EXPECT_EQ(path_beside("a.session.toml", "b.csv"), "b.csv");
  EXPECT_EQ(path_beside("folder/a.session.toml", "/b.csv"), "/b.csv");
  EXPECT_EQ(path_beside("folder/a.session.toml", "-"), "-");
}

TEST(PathBeside, LeadsBackToThePathThatItWasMadeFrom) {
  for (const char* file : {"a.toml", "one/a.toml", "one/two/a.toml", "../a.toml"}) {
    for (const char* path : {"b.csv", "one/b.csv", "three/b.csv", "/tmp/b.csv", "-"}) {
      const std::string written = path_to_write(file, path);
      if (std::string(file) == "../a.toml" && written[0] == '/') continue;  // see below
      EXPECT_EQ(path_beside(file, written), path) << file;
    }
  }
}

TEST(PathBeside, IsAbsoluteWhereTheWayBackIsUnknown) {
  const std::string here = std::filesystem::current_path().string();
  EXPECT_EQ(path_to_write("/tmp/a.toml", "b.csv"), here + "/b.csv");
  EXPECT_EQ(path_to_write("../a.toml", "b.csv"), here + "/b.csv");
}

}  // namespace
}  // namespace armcal
