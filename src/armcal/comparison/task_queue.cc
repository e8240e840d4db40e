// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/comparison/task_queue.h"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "armcal/core/parallel.h"

namespace armcal {

void do_tasks(const std::vector<double>& efforts, int threads, const Monitor& monitor,
              std::string_view stage, const std::function<void(std::size_t task)>& body) {
  std::vector<std::size_t> order(efforts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return efforts[one] > efforts[other];
  });
  const double whole = std::accumulate(efforts.begin(), efforts.end(), 0.0);
  std::mutex mutex;  // a listener hears one thread at a time
  double done = 0.0;
  monitor.report(stage, 0.0);
  parallel_for(static_cast<int>(order.size()), threads, [&](int item, int /*worker*/) {
    const std::size_t task = order[static_cast<std::size_t>(item)];
    body(task);
    const std::scoped_lock lock(mutex);
    done += efforts[task];
    monitor.report(stage, std::min(1.0, done / whole));
  });
}

}  // namespace armcal
