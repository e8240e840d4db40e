// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "armcal/core/diagnostics.h"
#include "armcal/core/spelling.h"

namespace armcal {
namespace {

[[noreturn]] void fail(const std::string& path, std::string_view what) {
  throw FileError(fmt::format("{}: cannot {}: {}", path, what, std::strerror(errno)));
}

// A temporary file that is removed unless it was kept.
class Temporary {
 public:
  explicit Temporary(const std::string& target) {
    for (int attempt = 0; descriptor_ < 0 && attempt < 100; ++attempt) {
      path_ = fmt::format("{}.tmp{}-{}", target, ::getpid(), attempt);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail(target, "write");
  }
  ~Temporary() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (descriptor_ >= 0 && !kept_) ::unlink(path_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  void write(std::string_view bytes, const std::string& target) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0) {
        if (errno == EINTR) continue;
        fail(target, "write");
      }
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(target, "write");
  }
  void become(const std::string& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) fail(target, "write");
    kept_ = true;
  }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void check_may_write(const std::string& path, Overwrite overwrite) {
  check_may_overwrite(path, overwrite);
  check_folder_of(path);
}

void check_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (path == "-" || folder.empty()) return;
  std::error_code ignored;
  const auto kind = std::filesystem::status(folder, ignored).type();
  if (kind == std::filesystem::file_type::not_found) {
    throw FileError(fmt::format(
        "cannot write {}: the folder {} does not exist\n  help: make it first: mkdir -p "
        "{}",
        path, folder.string(), shell_word(folder.string())));
  }
  const bool is_known =
      kind != std::filesystem::file_type::none && kind != std::filesystem::file_type::unknown;
  if (is_known && kind != std::filesystem::file_type::directory) {
    throw FileError(fmt::format("cannot write {}: {} is no folder", path, folder.string()));
  }
}

void check_may_overwrite(const std::string& path, Overwrite overwrite) {
  if (path == "-") return;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    Diagnostics diagnostics;
    diagnostics.error({path, 0, 0}, "is a folder: cannot write a file there");
    throw InputError(diagnostics);
  }
  // Devices such as /dev/null are written to, never replaced.
  if (overwrite == Overwrite::refuse && std::filesystem::is_regular_file(path, ignored)) {
    Diagnostics diagnostics;
    diagnostics.error({path, 0, 0}, "exists already", "give --force to overwrite it");
    throw InputError(diagnostics);
  }
}

void write_file(const std::string& path, std::string_view bytes, Overwrite overwrite) {
  check_may_write(path, overwrite);
  std::error_code ignored;
  const bool special =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  if (path == "-" || special) {
    std::FILE* out = path == "-" ? stdout : std::fopen(path.c_str(), "wb");
    if (out == nullptr) fail(path, "write");
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
    const bool flushed = std::fflush(out) == 0;
    if (out != stdout) std::fclose(out);
    if (!written || !flushed) fail(path, "write");
    return;
  }
  Temporary temporary(path);
  temporary.write(bytes, path);
  temporary.become(path);
}

}  // namespace armcal
