// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/task_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace armcal {
namespace {

TEST(DoingTasks, DoesEachOfThemOnce) {
  for (const int threads : {1, 2, 3}) {
    std::vector<std::atomic<int>> done(40);
    do_tasks(std::vector<double>(40, 1.0), threads, {}, "counting",
             [&](std::size_t task) { ++done[task]; });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

TEST(DoingTasks, BeginsWithTheLongest) {
  std::vector<std::size_t> order;
  do_tasks({1.0, 5.0, 3.0, 5.0}, 1, {}, "ordering",
           [&](std::size_t task) { order.push_back(task); });
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 3, 2, 0}));
}

TEST(DoingTasks, TellsHowMuchIsDone) {
  std::vector<double> heard;
  const Monitor monitor{[&](const Progress& progress) { heard.push_back(progress.fraction); }, {}};
  do_tasks({3.0, 1.0}, 2, monitor, "listening", [](std::size_t) {});
  ASSERT_EQ(heard.size(), 3u);
  EXPECT_EQ(heard.front(), 0.0);
  EXPECT_EQ(heard.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
}

TEST(DoingTasks, PassesOnWhatGoesWrong) {
  EXPECT_THROW(
      do_tasks({1.0, 1.0}, 2, {}, "failing", [](std::size_t) { throw std::runtime_error("so"); }),
      std::runtime_error);
}

}  // namespace
}  // namespace armcal
