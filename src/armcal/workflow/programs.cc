// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/programs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "armcal/core/diagnostics.h"

namespace armcal {

bool is_program(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

std::optional<std::string> program_in_path(std::span<const std::string_view> names) {
  const char* path = std::getenv("PATH");
  for (const std::string_view name : names) {
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      const std::string program = (std::filesystem::path(folder) / name).string();
      if (is_program(program)) return program;
    }
  }
  return std::nullopt;
}

std::string file_url(std::string_view path) {
  std::string url = "file://";
  for (const char c : path) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_plain =
        code < 0x80 &&
        (std::isalnum(code) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos);
    url += is_plain ? std::string(1, c) : fmt::format("%{:02X}", code);
  }
  return url;
}

pid_t start_program(const std::vector<std::string>& words, const std::string& output,
                    Belonging belonging) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t manner;
  posix_spawnattr_init(&manner);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&manner, &none);
  posix_spawnattr_setflags(
      &manner, static_cast<short>(POSIX_SPAWN_SETSIGMASK |
                                  (belonging == Belonging::own_group ? POSIX_SPAWN_SETPGROUP
                                                                     : POSIX_SPAWN_SETSID)));
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, words.front().c_str(), &files, &manner, arguments.data(), environ);
  posix_spawnattr_destroy(&manner);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) throw FileError(fmt::format("{} cannot be started", words.front()));
  return child;
}

void open_in_browser(const std::string& path) {
  constexpr std::array<std::string_view, 2> kOpeners = {"xdg-open", "open"};
  const auto opener = program_in_path(kOpeners);
  if (!opener) {
    throw FileError(
        fmt::format("nothing here opens web pages (no xdg-open): open {} in a browser", path));
  }
  static_cast<void>(start_program({*opener, path}, "/dev/null", Belonging::own_session));
}

}  // namespace armcal
