// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string_view>

namespace armcal {

/// How far a long job has come.
struct Progress {
  std::string_view stage;  ///< what is being done, in words a user knows
  double fraction = 0.0;   ///< 0 to 1 within this stage
};

using ProgressCallback = std::function<void(const Progress&)>;

/// Thrown by a long job that was asked to stop. Nothing has been written.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// What every long job takes: a listener (may be empty) and a way to be stopped.
struct Monitor {
  ProgressCallback on_progress;
  std::stop_token stop;

  /// Tells the listener; throws Interrupted when a stop has been requested.
  void report(std::string_view stage, double fraction) const {
    if (stop.stop_requested()) throw Interrupted();
    if (on_progress) on_progress({stage, fraction});
  }
};

}  // namespace armcal
