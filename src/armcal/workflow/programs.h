// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace armcal {

/// Can this file be run?
[[nodiscard]] bool is_program(const std::string& path);

/// The first of these names that a folder of PATH has as a program, with its folder.
[[nodiscard]] std::optional<std::string> program_in_path(std::span<const std::string_view> names);

/// Opens a file in the user's browser (xdg-open, open) and does not wait for it.
/// @throws FileError where nothing here opens web pages, with what to do
void open_in_browser(const std::string& path);

}  // namespace armcal
