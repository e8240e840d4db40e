// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace armcal {
namespace {

TEST(ParallelFor, CallsEveryItemOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    std::vector<int> calls(1000, 0);
    parallel_for(1000, threads, [&](int item, int) { ++calls[static_cast<std::size_t>(item)]; });
    EXPECT_THAT(calls, testing::Each(1)) << threads;
  }
  parallel_for(0, 4, [](int, int) { FAIL(); });
}

TEST(ParallelFor, StaysOnTheCallingThreadWhenThereIsNothingToShare) {
  const auto here = std::this_thread::get_id();
  parallel_for(5, 1, [&](int, int) { EXPECT_EQ(std::this_thread::get_id(), here); });
  parallel_for(1, 8, [&](int, int) { EXPECT_EQ(std::this_thread::get_id(), here); });
}

TEST(ParallelFor, GivesNoWorkerTwoItemsAtATime) {
  std::vector<std::atomic<int>> busy(3);
  parallel_for(300, 3, [&](int, int worker) {
    ASSERT_LT(worker, 3);
    std::atomic<int>& count = busy[static_cast<std::size_t>(worker)];
    EXPECT_EQ(++count, 1);
    std::this_thread::yield();
    --count;
  });
}

TEST(ParallelFor, ThrowsWhatTheFirstFailingItemThrew) {
  for (const int threads : {1, 2, 8}) {
    for (int repetition = 0; repetition < 20; ++repetition) {
      try {
        parallel_for(100, threads, [](int item, int) {
          if (item >= 7) throw std::runtime_error(std::to_string(item));
        });
        FAIL();
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "7");
      }
    }
  }
}

TEST(ParallelFor, MayBeNested) {
  std::vector<int> sums(8, 0);
  parallel_for(8, 3, [&](int item, int) {
    std::vector<int> parts(50, 0);
    parallel_for(50, 2, [&](int part, int) { parts[static_cast<std::size_t>(part)] = part; });
    for (const int part : parts) sums[static_cast<std::size_t>(item)] += part;
  });
  EXPECT_THAT(sums, testing::Each(1225));
}

}  // namespace
}  // namespace armcal
