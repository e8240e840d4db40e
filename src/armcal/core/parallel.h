// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace armcal {

/// Calls body(item, worker) once for every item of 0 .. items - 1, on up to `threads` threads, and
/// returns when all calls have. Items are handed out in ascending order; no two calls that run at
/// the same time have the same worker, 0 <= worker < threads, so a worker's workspace needs no
/// lock. A result that is written to a place of the item, and put together afterwards in the order
/// of the items, does not depend on the number of threads.
///
/// With one thread or one item everything happens on the calling thread.
/// An exception stops the handing out and comes out of here once the calls that had begun are over;
/// of several, that of the first item: the same one for every number of threads.
void parallel_for(int items, int threads, const std::function<void(int item, int worker)>& body);

}  // namespace armcal
