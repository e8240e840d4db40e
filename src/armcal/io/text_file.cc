// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "armcal/io/sha256.h"
#include "armcal/io/text_encoding.h"

namespace armcal {
namespace {

struct Closer {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.0f} MB", static_cast<double>(bytes) / 1e6);
}

// Everything up to the limit plus one byte, by which a longer file shows.
std::string read_bytes(std::FILE* file, const std::string& path, std::uint64_t largest,
                       std::uint64_t expected, const Monitor& monitor) {
  constexpr std::size_t kChunk = std::size_t{4} << 20;
  std::string bytes;
  bytes.reserve(expected + 1);
  for (;;) {
    const std::size_t old = bytes.size();
    const auto room = static_cast<std::size_t>(largest + 1 - old);
    bytes.resize(old + std::min(kChunk, room));
    const std::size_t got = std::fread(bytes.data() + old, 1, bytes.size() - old, file);
    bytes.resize(old + got);
    if (std::ferror(file) != 0) {
      throw FileError(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
    }
    if (got == 0 || bytes.size() > largest) return bytes;
    if (expected > kChunk) {
      monitor.report("reading " + path, std::min(1.0, static_cast<double>(bytes.size()) /
                                                          static_cast<double>(expected)));
    }
  }
}

}  // namespace

std::string path_beside(const std::string& file, const std::string& path) {
  if (path == "-" || std::filesystem::path(path).is_absolute()) return path;
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

std::string path_to_write(const std::string& file, const std::string& path) {
  const auto folder = std::filesystem::path(file).parent_path();
  if (path == "-" || std::filesystem::path(path).is_absolute() || folder.empty()) return path;
  // Empty where only one of the two is absolute, or where the way leads through an unknown "..".
  const auto relative = std::filesystem::path(path).lexically_relative(folder);
  return relative.empty() ? std::filesystem::absolute(path).lexically_normal().string()
                          : relative.string();
}

std::optional<TextFile> read_text_file(const std::string& path, std::uint64_t largest_bytes,
                                       Diagnostics& diagnostics, const Monitor& monitor) {
  const SourcePosition where{path == "-" ? "standard input" : path, 0, 0};
  std::unique_ptr<std::FILE, Closer> file;
  std::uint64_t expected = 0;
  if (path == "-") {
    file.reset(stdin);
  } else {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
      diagnostics.error(where, "is a folder, not a file");
      return std::nullopt;
    }
    file.reset(std::fopen(path.c_str(), "rb"));
    if (!file) {
      diagnostics.error(where, fmt::format("cannot open: {}", std::strerror(errno)));
      return std::nullopt;
    }
    const auto size = std::filesystem::file_size(path, ignored);
    if (!ignored) expected = std::min<std::uint64_t>(size, largest_bytes);
  }
  std::string bytes = read_bytes(file.get(), path, largest_bytes, expected, monitor);
  if (bytes.size() > largest_bytes) {
    diagnostics.error(where,
                      fmt::format("is larger than {}, the most that is read of such a file",
                                  megabytes(largest_bytes)),
                      "is it the file you meant?");
    return std::nullopt;
  }
  if (bytes.empty()) {
    diagnostics.error(where, "is empty");
    return std::nullopt;
  }
  TextFile result{path, {}, {}, sha256_hex(bytes)};
  DecodedText decoded = decode_text(std::move(bytes));
  if (const auto offset = first_binary_byte(decoded.text)) {
    diagnostics.error(where,
                      fmt::format("is not a text file: byte 0x{:02x} at offset {}",
                                  static_cast<unsigned char>(decoded.text[*offset]), *offset),
                      "export it as CSV or TOML text");
    return std::nullopt;
  }
  result.text = std::move(decoded.text);
  result.encoding = std::move(decoded.encoding);
  return result;
}

}  // namespace armcal
