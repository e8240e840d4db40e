// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

#include "armcal/core/progress.h"

namespace armcal::cli {

/// A bar with the time left, on one line of a terminal: drawn from half a second on, ten times a
/// second at most, wiped at the end.
class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ProgressBar(std::ostream& terminal) : terminal_(terminal) {}
  ~ProgressBar() { wipe(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress, Clock::time_point now = Clock::now());
  void wipe();

 private:
  std::ostream& terminal_;
  std::string stage_;
  Clock::time_point stage_start_{};
  Clock::time_point last_drawn_{};
  bool visible_ = false;
};

/// "[######....] 60 %  12 s left  reading a.csv"
[[nodiscard]] std::string progress_line(std::string_view stage, double fraction, double elapsed_s);

}  // namespace armcal::cli
