// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "armcal/core/diagnostics.h"
#include "armcal/report/html/page_html.h"
#include "armcal/report/pages/pages.h"

// Any result document, or bytes that look like one, becomes a page that gives it back, or is
// complained of.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const armcal::Json document = armcal::Json::parse(text, nullptr, false);
  if (document.is_discarded()) return 0;
  const armcal::Language& say = armcal::Language::named(size % 2 == 0 ? "en" : "zh");
  try {
    const armcal::Page page = armcal::page_of(armcal::DocumentView(document, "fuzz"), say, {});
    const std::string printed =
        document.dump(-1, ' ', false, armcal::Json::error_handler_t::replace);
    if (armcal::document_in_html(armcal::html_of(page, say, printed)) != printed) std::abort();
  } catch (const armcal::InputError&) {
    // names the key
  }
  return 0;
}
