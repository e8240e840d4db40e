// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/text_encoding.h"

#include <iconv.h>

#include <algorithm>
#include <utility>

namespace armcal {
namespace {

unsigned char byte(char c) { return static_cast<unsigned char>(c); }

// Length of the UTF-8 sequence that starts at `i`, or 0 where there is none. Over-long forms and
// surrogates are refused, as the standard asks.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const unsigned char lead = byte(text[i]);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(text[i + k]) & 0xC0) != 0x80) return 0;
  }
  const unsigned char second = byte(text[i + 1]);
  if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
      (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F)) {
    return 0;
  }
  return length;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

// GB 2312 characters are pairs of bytes from A1 on; Latin-1 letters stand alone between ASCII.
bool looks_like_gb18030(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (byte(text[i]) < 0x80) continue;
    const bool pair = i + 1 < text.size() && byte(text[i]) >= 0xA1 && byte(text[i]) <= 0xF7 &&
                      byte(text[i + 1]) >= 0xA1 && byte(text[i + 1]) <= 0xFE;
    if (!pair) return false;
    ++i;
  }
  return true;
}

std::optional<std::string> converted(std::string_view bytes, const char* from) {
  iconv_t converter = iconv_open("UTF-8", from);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the value that POSIX defines for failure
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string in(bytes);
  std::string out(bytes.size() * 3 + 16, '\0');
  char* read = in.data();
  char* write = out.data();
  std::size_t in_left = in.size();
  std::size_t out_left = out.size();
  const std::size_t failed = iconv(converter, &read, &in_left, &write, &out_left);
  iconv_close(converter);
  if (failed == static_cast<std::size_t>(-1)) return std::nullopt;
  out.resize(out.size() - out_left);
  return out;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const unsigned char code = byte(c);
    if (code < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

// Without a mark: ASCII text in UTF-16 has a zero in every other byte.
const char* utf16_by_shape(std::string_view bytes) {
  const std::size_t looked_at = std::min<std::size_t>(bytes.size(), 256) & ~std::size_t{1};
  if (looked_at < 4) return nullptr;
  std::size_t even = 0;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < looked_at; i += 2) {
    even += bytes[i] == '\0';
    odd += bytes[i + 1] == '\0';
  }
  const std::size_t most = looked_at / 2 - looked_at / 16;
  if (odd >= most && even == 0) return "UTF-16LE";
  if (even >= most && odd == 0) return "UTF-16BE";
  return nullptr;
}

}  // namespace

std::optional<std::size_t> first_binary_byte(std::string_view utf8) {
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const unsigned char c = byte(utf8[i]);
    const bool usual = c >= 0x20 || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == 0x1A;
    if (!usual) return i;
  }
  return std::nullopt;
}

DecodedText decode_text(std::string bytes) {
  using namespace std::literals;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  const char* utf16 = nullptr;
  if (bytes.starts_with("\xFF\xFE"sv)) utf16 = "UTF-16LE";
  if (bytes.starts_with("\xFE\xFF"sv)) utf16 = "UTF-16BE";
  const std::size_t mark = utf16 != nullptr ? 2 : 0;
  if (utf16 == nullptr) utf16 = utf16_by_shape(bytes);
  if (utf16 != nullptr) {
    if (auto text = converted(std::string_view(bytes).substr(mark), utf16)) {
      return {std::move(*text), "UTF-16"};
    }
  }
  if (is_utf8(bytes)) return {std::move(bytes), "UTF-8"};
  if (looks_like_gb18030(bytes)) {
    if (auto text = converted(bytes, "GB18030")) return {std::move(*text), "GB18030"};
  }
  return {from_latin1(bytes), "Latin-1"};
}

}  // namespace armcal
