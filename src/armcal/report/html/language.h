// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace armcal {

/// What reports say, in one language: texts by key, from report/languages/CODE.json. Numbers,
/// symbols and names of parameters are the same in all of them.
class Language {
 public:
  /// @param code  "en" or "zh" @throws std::invalid_argument with the codes that there are
  [[nodiscard]] static const Language& named(std::string_view code);
  [[nodiscard]] static std::vector<std::string> codes();

  [[nodiscard]] const std::string& code() const { return code_; }

  /// The text of a key ("calibration.title") with values in the place of {0}, {1}, ..
  /// @throws std::logic_error for a key that there is not
  template <typename... Values>
  [[nodiscard]] std::string operator()(std::string_view key, const Values&... values) const {
    const std::vector<std::string> texts = {fmt::format("{}", values)...};
    return say(key, texts);
  }
  [[nodiscard]] bool has(std::string_view key) const;
  /// All keys in order, for tests.
  [[nodiscard]] std::vector<std::string> keys() const;

 private:
  Language(std::string code, std::string_view json);
  [[nodiscard]] std::string say(std::string_view key, std::span<const std::string> values) const;

  std::string code_;
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace armcal
