// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/document_view.h"

#include "armcal/report/html/visible_text.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace armcal {

void DocumentView::complain(const std::string& message) const {
  Diagnostics diagnostics;
  diagnostics.error(
      {file_, 0, 0}, path_.empty() ? message : fmt::format("key {}: {}", path_, message),
      "a result is what armcal prints with --json or saves with --save; make it anew");
  throw InputError(diagnostics);
}

bool DocumentView::has(std::string_view key) const {
  if (!json_->is_object()) return false;
  const auto found = json_->find(key);
  return found != json_->end() && !found->is_null();
}

DocumentView DocumentView::operator[](std::string_view key) const {
  DocumentView inner = *this;
  inner.path_ = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  if (!has(key)) inner.complain("is missing");
  inner.json_ = &*json_->find(key);
  return inner;
}

std::vector<DocumentView> DocumentView::items() const {
  if (!json_->is_array()) complain("is not a list");
  std::vector<DocumentView> items;
  for (std::size_t i = 0; i < json_->size(); ++i) {
    DocumentView item = *this;
    item.path_ = fmt::format("{}[{}]", path_, i);
    item.json_ = &(*json_)[i];
    items.push_back(std::move(item));
  }
  return items;
}

std::vector<DocumentView> DocumentView::list(std::string_view key) const {
  return (*this)[key].items();
}

std::string DocumentView::as_text() const {
  if (!json_->is_string()) complain("is not a text");
  return visible_text(json_->get_ref<const std::string&>());
}

double DocumentView::as_number() const {
  if (!json_->is_number()) complain("is not a number");
  return json_->get<double>();
}

bool DocumentView::as_flag() const {
  if (!json_->is_boolean()) complain("is neither true nor false");
  return json_->get<bool>();
}

std::optional<double> DocumentView::as_number_if() const {
  return json_->is_null() ? std::nullopt : std::optional(as_number());
}

std::vector<double> DocumentView::as_numbers() const {
  if (!json_->is_array()) complain("is not a list");
  std::vector<double> numbers;
  numbers.reserve(json_->size());
  for (const Json& each : *json_) {
    // What is not finite is null in JSON.
    if (!each.is_number() && !each.is_null()) complain("holds what is not a number");
    numbers.push_back(each.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                     : each.get<double>());
  }
  return numbers;
}

std::string DocumentView::text(std::string_view key) const { return (*this)[key].as_text(); }
double DocumentView::number(std::string_view key) const { return (*this)[key].as_number(); }

int DocumentView::ordinal(std::string_view key, int count) const {
  const DocumentView place = (*this)[key];
  const double value = place.as_number();
  if (!(value >= 1.0 && value <= count) || value != std::floor(value)) {
    place.complain(fmt::format("is none of 1 to {}", count));
  }
  return static_cast<int>(value);
}

bool DocumentView::flag(std::string_view key) const { return (*this)[key].as_flag(); }

std::optional<std::string> DocumentView::text_if(std::string_view key) const {
  return has(key) ? std::optional(text(key)) : std::nullopt;
}

std::optional<double> DocumentView::number_if(std::string_view key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

std::vector<double> DocumentView::numbers(std::string_view key) const {
  return (*this)[key].as_numbers();
}

std::vector<std::string> DocumentView::texts(std::string_view key) const {
  std::vector<std::string> texts;
  for (const DocumentView& each : list(key)) texts.push_back(each.as_text());
  return texts;
}

}  // namespace armcal
