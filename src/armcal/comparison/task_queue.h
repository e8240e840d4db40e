// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "armcal/core/progress.h"

namespace armcal {

/// Does all tasks, the longest first so that no thread is left alone with one at the end, and tells
/// the listener how much of the whole effort is behind us. Tasks must not depend on each other.
/// @param efforts  rough computing time of each task, any unit
/// @param body     called once for each task, from several threads at a time
void do_tasks(const std::vector<double>& efforts, int threads, const Monitor& monitor,
              std::string_view stage, const std::function<void(std::size_t task)>& body);

}  // namespace armcal
