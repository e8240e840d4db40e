// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// Can this file be run?
[[nodiscard]] bool is_program(const std::string& path);

/// The first of these names that a folder of PATH has as a program, with its folder.
[[nodiscard]] std::optional<std::string> program_in_path(std::span<const std::string_view> names);

/// The address of a file for a browser: what has a meaning in addresses (#, ?, %, blanks) is
/// escaped.
/// @param path  from the root of the file system
[[nodiscard]] std::string file_url(std::string_view path);

/// How programs are started: no signal is blocked as it is in ours, and what they start in turn
/// belongs to them.
enum class Belonging { own_group, own_session };
/// @param words   the program with its folder, and its arguments
/// @param output  file for what it says on both its outputs; "/dev/null" for none
/// @throws FileError where it cannot be started
[[nodiscard]] pid_t start_program(const std::vector<std::string>& words, const std::string& output,
                                  Belonging belonging);

/// Opens a file in the user's browser (xdg-open, open) and does not wait for it.
/// @throws FileError where nothing here opens web pages, with what to do
void open_in_browser(const std::string& path);

}  // namespace armcal
