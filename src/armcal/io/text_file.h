// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "armcal/core/diagnostics.h"
#include "armcal/core/progress.h"

namespace armcal {

/// A text file as read: decoded to UTF-8, with what a report must say about its inputs.
struct TextFile {
  std::string path;      ///< as the user gave it; "-" is standard input
  std::string text;      ///< UTF-8, line ends as in the file
  std::string encoding;  ///< of the file
  std::string sha256;    ///< of its bytes
};

/// Largest table that is read (offsets within it are 32 bits) and largest configuration file that
/// makes sense.
inline constexpr std::uint64_t kLargestTable_bytes = std::uint64_t{1} << 32;
inline constexpr std::uint64_t kLargestConfiguration_bytes = std::uint64_t{4} << 20;

/// A path that a file names, as seen from where the program runs: relative ones start beside that
/// file; "-" stays.
[[nodiscard]] std::string path_beside(const std::string& file, const std::string& path);

/// What to write in `file` so that it names `path`: `path_beside` leads back to it. Absolute where
/// the way from one to the other is unknown.
[[nodiscard]] std::string path_to_write(const std::string& file, const std::string& path);

/// Reads a whole file, or standard input for "-". What the user can mend goes to `diagnostics` (no
/// such file, a folder, empty, too large, not text) and nothing is returned. @throws FileError
/// where the device fails.
[[nodiscard]] std::optional<TextFile> read_text_file(const std::string& path,
                                                     std::uint64_t largest_bytes,
                                                     Diagnostics& diagnostics,
                                                     const Monitor& monitor = {});

}  // namespace armcal
