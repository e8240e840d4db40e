// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace armcal {

enum class Overwrite { refuse, allow };

/// Writes a whole file or nothing: to a temporary file beside it, flushed to the device, then
/// renamed. "-" writes to standard output. @throws InputError where the file exists and may not be
/// overwritten, FileError where its folder does not exist or the device fails.
void write_file(const std::string& path, std::string_view bytes, Overwrite overwrite);

/// The checks alone, to be made before long work. @throws as above
void check_may_write(const std::string& path, Overwrite overwrite);

/// Only that nothing is overwritten: for files whose folder is yet to be made. @throws InputError
/// as above
void check_may_overwrite(const std::string& path, Overwrite overwrite);

/// Only that there is a folder for the file. @throws FileError as above
void check_folder_of(const std::string& path);

}  // namespace armcal
