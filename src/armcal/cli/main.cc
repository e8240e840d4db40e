// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "armcal/cli/app.h"
#include "armcal/cli/command.h"

namespace {

// Waits for Ctrl-C on a thread of its own: asks the job to stop, and ends the program where it does
// not (blocked on a pipe, say) or where the user insists. Files are written whole or not at all, so
// nothing is torn.
void stop_on_signal(const std::stop_source& source) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([source, signals]() mutable {
    int signal = 0;
    sigwait(&signals, &signal);
    source.request_stop();
    const timespec patience{2, 0};
    sigtimedwait(&signals, nullptr, &patience);
    _exit(armcal::cli::kInterrupted);
  }).detach();
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  armcal::cli::end_with_exit_code_on_abort();
  std::stop_source source;
  stop_on_signal(source);
  const int code = armcal::cli::run(
      arguments, {std::cout, std::cerr, isatty(STDERR_FILENO) != 0, source.get_token()});
  std::cout.flush();
  return code;
}
