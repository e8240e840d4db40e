// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/programs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
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

void open_in_browser(const std::string& path) {
  constexpr std::array<std::string_view, 2> kOpeners = {"xdg-open", "open"};
  const auto opener = program_in_path(kOpeners);
  if (!opener) {
    throw FileError(
        fmt::format("nothing here opens web pages (no xdg-open): open {} in a browser", path));
  }
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  }
  std::string program = *opener;
  std::string file = path;
  char* arguments[] = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawn(&child, program.c_str(), &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) throw FileError(fmt::format("{} cannot be started", program));
}

}  // namespace armcal
