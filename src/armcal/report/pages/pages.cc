// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/pages.h"

#include <array>
#include <nlohmann/json.hpp>

#include "armcal/io/sha256.h"
#include "armcal/report/pages/calibration_page.h"
#include "armcal/report/pages/check_page.h"
#include "armcal/report/pages/comparison_page.h"
#include "armcal/report/pages/demo_page.h"
#include "armcal/report/pages/details_sections.h"
#include "armcal/report/pages/diff_page.h"
#include "armcal/report/pages/fit_page.h"
#include "armcal/report/pages/half_turn_plan_page.h"
#include "armcal/report/pages/plain_page.h"
#include "armcal/report/pages/plan_page.h"
#include "armcal/report/pages/probe_page.h"
#include "armcal/report/pages/sphere_test_page.h"
#include "armcal/report/pages/symmetric_point_page.h"
#include "armcal/report/pages/tips_page.h"
#include "armcal/report/pages/verification_page.h"

namespace armcal {
namespace {

struct PageKind {
  std::string_view command;
  Page (*make)(const DocumentView& document, const Language& say);
};

// A new page is a new file and a line here.
constexpr std::array kPages = {
    PageKind{"calibrate", calibration_page},
    PageKind{"identifiability", identifiability_page},
    PageKind{"symmetric-point", symmetric_point_page},
    PageKind{"compare", comparison_page},
    PageKind{"demo", demo_page},
    PageKind{"verify iso10360-12", verification_page},
    PageKind{"verify b89.4.22", verification_page},
    PageKind{"verify sphere", sphere_test_page},
    PageKind{"check", check_page},
    PageKind{"plan verification", verification_plan_page},
    PageKind{"probe", probe_page},
    PageKind{"plan symmetric-point", half_turn_plan_page},
    PageKind{"diff", diff_page},
    PageKind{"fit", fit_page},
    PageKind{"register", registration_page},
    PageKind{"fk", tips_page},
    PageKind{"predict", tips_page},
};

Page page_by_command(const DocumentView& document, const Language& say) {
  const std::string command = document.text("command");
  for (const PageKind& kind : kPages) {
    if (kind.command == command) return kind.make(document, say);
  }
  return plain_page(document, say);
}

void check_schema(const DocumentView& document) {
  if (!document.json().is_object() || !document.has("schema")) {
    document.complain("is no result of armcal");
  }
  const std::string schema = document.text("schema");
  // 1.x is read as 1: minor versions only add.
  if (schema != "armcal.result/1" && !schema.starts_with("armcal.result/1.")) {
    document["schema"].complain("is \"" + schema + "\"; this armcal reads armcal.result/1");
  }
  if (document.has("error")) {
    document["error"].complain("the command failed, so there is no result to report");
  }
}

// The same result has the same number wherever it is reported: the line that was typed names the
// report itself, and a seed shows in the numbers where it changes any.
std::string number_of(const DocumentView& document) {
  constexpr std::size_t kDigits = 12;
  Json result = document.json();
  result.erase("command_line");
  result.erase("seed");
  return "armcal-" +
         sha256_hex(result.dump(-1, ' ', false, Json::error_handler_t::replace)).substr(0, kDigits);
}

}  // namespace

Page page_of(const DocumentView& document, const Language& say, const ReportDetails& details) {
  check_schema(document);
  Page page = page_by_command(document, say);
  if (!details.title.empty()) page.title = details.title;
  page.number = details.number.empty() ? number_of(document) : details.number;
  add_details(details, say, page);
  page.sections.push_back(origin_section(document, say));
  return page;
}

}  // namespace armcal
