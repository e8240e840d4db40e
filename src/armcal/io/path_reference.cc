// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/path_reference.h"

#include <filesystem>

namespace armcal {
namespace {

bool stands_alone(const std::string& path) {
  return path == "-" || std::filesystem::path(path).is_absolute();
}

}  // namespace

std::string resolved_path(const std::string& file, const std::string& path) {
  if (stands_alone(path)) return path;
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

std::string relative_path(const std::string& file, const std::string& path) {
  const auto folder = std::filesystem::path(file).parent_path();
  if (stands_alone(path) || folder.empty()) return path;
  // Empty where only one of the two is absolute, or where the way leads through an unknown "..".
  const auto relative = std::filesystem::path(path).lexically_relative(folder);
  return relative.empty() ? std::filesystem::absolute(path).lexically_normal().string()
                          : relative.string();
}

}  // namespace armcal
