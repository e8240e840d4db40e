// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace armcal {

/// Text in UTF-8 without byte order mark, and what it was before.
struct DecodedText {
  std::string text;
  std::string encoding;  ///< "UTF-8", "UTF-16", "GB18030" or "Latin-1"
};

/// Offset of the first byte that shows that these bytes are no text (a control character that no
/// text file has), or nothing.
[[nodiscard]] std::optional<std::size_t> first_binary_byte(std::string_view utf8);

/// Decodes the bytes of a text file as measuring software writes them: UTF-8 and UTF-16 by their
/// mark or their shape; else GB18030 where every foreign character is a pair from the GB 2312
/// planes, else Latin-1, which takes everything.
[[nodiscard]] DecodedText decode_text(std::string bytes);

}  // namespace armcal
