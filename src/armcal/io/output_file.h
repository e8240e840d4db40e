// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace armcal {

enum class Overwrite { refuse, allow };

/// Writes a whole file or nothing: to a temporary file beside it, flushed to the device, then
/// renamed. "-" writes to standard output. @throws InputError where the file exists and may not be
/// overwritten, FileError where the device fails.
void write_file(const std::string& path, std::string_view bytes, Overwrite overwrite);

/// The check alone, to be made before long work. @throws InputError as above
void check_may_write(const std::string& path, Overwrite overwrite);

}  // namespace armcal
