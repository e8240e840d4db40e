// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armcal/core/diagnostics.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::read_bytes;

TEST(OutputFile, WritesTheWholeFileAndNothingElse) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("a.csv");
  write_file(path, "hello", Overwrite::refuse);
  EXPECT_EQ(read_bytes(path), "hello");
  int entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path("")))
    ++entries;
  EXPECT_EQ(entries, 1);
}

TEST(OutputFile, NeverOverwritesUnlessAllowed) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "precious");
  try {
    write_file(path, "new", Overwrite::refuse);
    FAIL() << "overwrote";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.csv: error: exists already\n  help: give --force"));
  }
  EXPECT_EQ(read_bytes(path), "precious");
  write_file(path, "new", Overwrite::allow);
  EXPECT_EQ(read_bytes(path), "new");
}

TEST(OutputFile, FailsInWordsWhereTheDeviceDoes) {
  EXPECT_THROW(write_file("/no/such/folder/a.csv", "x", Overwrite::refuse), FileError);
  const testing::TemporaryFolder folder;
  EXPECT_THROW(write_file(folder.path(""), "x", Overwrite::allow), InputError);
}

std::string refusal_of_folder(const std::string& path) {
  try {
    check_may_write(path, Overwrite::allow);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(OutputFile, WantsItsFolderBeforeAnyWorkIsDone) {
  const testing::TemporaryFolder folder;
  const std::string missing = folder.path("missing");
  EXPECT_EQ(refusal_of_folder(missing + "/x.html"),
            "cannot write " + missing + "/x.html: the folder " + missing +
                " does not exist\n  help: make it first: mkdir -p " + missing);
  EXPECT_THAT(refusal_of_folder(folder.path("a folder/x.html")),
              HasSubstr("mkdir -p '" + folder.path("a folder") + "'"));
  EXPECT_THAT(refusal_of_folder(folder.write("file", "") + "/x.html"), HasSubstr("is no folder"));
  for (const std::string& path : {folder.path("x.html"), std::string("x.html"), std::string("-"),
                                  std::string("./x.html"), std::string("/dev/null")}) {
    EXPECT_EQ(refusal_of_folder(path), "") << path;
  }
}

TEST(OutputFile, WhoseFolderIsYetToBeMadeIsAskedOnlyWhetherItIsThere) {
  const testing::TemporaryFolder folder;
  EXPECT_NO_THROW(check_may_overwrite(folder.path("missing/a.csv"), Overwrite::refuse));
  EXPECT_THROW(check_may_overwrite(folder.write("a.csv", "x"), Overwrite::refuse), InputError);
}

TEST(OutputFile, WritesToDevices) { write_file("/dev/null", "x", Overwrite::refuse); }

TEST(OutputFile, AFullDeviceIsAnError) {
  EXPECT_THROW(write_file("/dev/full", "x", Overwrite::refuse), FileError);
}

}  // namespace
}  // namespace armcal
