// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/progress_bar.h"

#include <gtest/gtest.h>

#include <sstream>

namespace armcal::cli {
namespace {

TEST(ProgressLine, ShowsShareAndTimeLeft) {
  EXPECT_EQ(progress_line("reading a.csv", 0.5, 10.0),
            "[############............]  50 %  10 s left  reading a.csv");
  EXPECT_EQ(progress_line("x", 0.1, 60.0), "[##......................]  10 %  9 min left  x");
  EXPECT_EQ(progress_line("x", 2.0, 1.0), "[########################] 100 %  0 s left  x");
}

TEST(ProgressBar, IsSilentForShortJobsAndWipesItself) {
  std::ostringstream terminal;
  const auto start = ProgressBar::Clock::now();
  {
    ProgressBar bar(terminal);
    bar.show({"x", 0.1}, start);
    bar.show({"x", 0.2}, start + std::chrono::milliseconds(100));
    EXPECT_EQ(terminal.str(), "");
    bar.show({"x", 0.5}, start + std::chrono::seconds(1));
    EXPECT_NE(terminal.str().find("50 %"), std::string::npos);
    const auto size = terminal.str().size();
    bar.show({"x", 0.6}, start + std::chrono::milliseconds(1010));  // too soon
    EXPECT_EQ(terminal.str().size(), size);
  }
  EXPECT_TRUE(terminal.str().ends_with("\r\x1b[K"));
}

}  // namespace
}  // namespace armcal::cli
