// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armcal/report/document.h"

namespace armcal {

/// A place in a result document, read with care: documents come from files that anyone may have
/// edited. Every access that does not find what it wants throws InputError, which names the
/// document and the key ("saved.json: key tests[2].value_mm: is not a number").
class DocumentView {
 public:
  /// @param file  that the document came from, for messages
  DocumentView(const Json& json, std::string file) : json_(&json), file_(std::move(file)) {}

  /// Is there something (not null) under this key?
  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] DocumentView operator[](std::string_view key) const;         ///< must be there
  [[nodiscard]] std::vector<DocumentView> list(std::string_view key) const;  ///< an array under it
  [[nodiscard]] std::vector<DocumentView> items() const;  ///< this, which must be an array

  /// As it can be seen: `visible_text`.
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] bool flag(std::string_view key) const;
  /// A place among `count` things that are counted from 1, as of a joint.
  [[nodiscard]] int ordinal(std::string_view key, int count) const;
  /// Nothing where the key is missing or null; complains of another type.
  [[nodiscard]] std::optional<std::string> text_if(std::string_view key) const;
  [[nodiscard]] std::optional<double> number_if(std::string_view key) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;

  // The value here itself.
  [[nodiscard]] std::string as_text() const;
  [[nodiscard]] double as_number() const;
  [[nodiscard]] bool as_flag() const;
  [[nodiscard]] std::optional<double> as_number_if() const;
  [[nodiscard]] std::vector<double> as_numbers() const;

  [[nodiscard]] const Json& json() const { return *json_; }
  /// @throws InputError at this place
  [[noreturn]] void complain(const std::string& message) const;

 private:
  const Json* json_;
  std::string file_;
  std::string path_;
};

}  // namespace armcal
