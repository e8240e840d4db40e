// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/progress_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace armcal::cli {
namespace {

constexpr auto kFirstDraw = std::chrono::milliseconds(500);
constexpr auto kBetweenDraws = std::chrono::milliseconds(100);
constexpr int kWidth = 24;

}  // namespace

std::string progress_line(std::string_view stage, double fraction, double elapsed_s) {
  const double share = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(std::lround(share * kWidth));
  std::string left;
  if (share > 0.02) {
    const double seconds = elapsed_s * (1.0 - share) / share;
    left = seconds < 90.0 ? fmt::format("{:.0f} s left", seconds)
                          : fmt::format("{:.0f} min left", seconds / 60.0);
  }
  return fmt::format(
      "[{}{}] {:>3.0f} %  {}  {}", std::string(static_cast<std::size_t>(filled), '#'),
      std::string(static_cast<std::size_t>(kWidth - filled), '.'), 100.0 * share, left, stage);
}

void ProgressBar::show(const Progress& progress, Clock::time_point now) {
  if (progress.stage != stage_) {
    stage_ = progress.stage;
    stage_start_ = now;
  }
  if (now - stage_start_ < kFirstDraw || now - last_drawn_ < kBetweenDraws) return;
  last_drawn_ = now;
  visible_ = true;
  const double elapsed = std::chrono::duration<double>(now - stage_start_).count();
  terminal_ << "\r\x1b[K" << progress_line(stage_, progress.fraction, elapsed) << std::flush;
}

void ProgressBar::wipe() {
  if (visible_) terminal_ << "\r\x1b[K" << std::flush;
  visible_ = false;
}

}  // namespace armcal::cli
