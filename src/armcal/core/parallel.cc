// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace armcal {
namespace {

// The exception of the lowest item. Items below one that throws were handed out before it and are
// not cut short, so the lowest one is not a matter of luck.
class FirstException {
 public:
  void keep(int item) {
    const std::scoped_lock lock(mutex_);
    if (exception_ && item_ < item) return;
    item_ = item;
    exception_ = std::current_exception();
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  int item_ = 0;
  std::exception_ptr exception_;
};

}  // namespace

void parallel_for(int items, int threads, const std::function<void(int item, int worker)>& body) {
  const int workers = std::min(items, threads);
  if (workers <= 1) {
    for (int item = 0; item < items; ++item) body(item, 0);
    return;
  }
  std::atomic<int> next = 0;
  FirstException first;
  // A worker is a task of our own that fetches items, not a thread of the pool: should a body wait
  // for tasks of its own, its thread may pick up another worker, never the same one again.
  const auto work = [&](int worker) {
    for (int item = next++; item < items; item = next++) {
      try {
        body(item, worker);
      } catch (...) {
        first.keep(item);
        next = items;
      }
    }
  };
  // Asked for more threads than there are, the pool would say so on stderr.
  tbb::task_arena arena(std::min(workers, tbb::info::default_concurrency()));
  arena.execute([&] { tbb::parallel_for(0, workers, work, tbb::simple_partitioner()); });
  first.rethrow();
}

}  // namespace armcal
