// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/report_job.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "armcal/io/sha256.h"
#include "armcal/report/html/page_html.h"
#include "armcal/report/pages/pages.h"

namespace armcal {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& message) {
  Diagnostics diagnostics;
  diagnostics.error({file, 0, 0}, message,
                    "give what armcal printed with --json, saved with --save, or a report of it");
  throw InputError(diagnostics);
}

Json parsed(const std::string& document, const std::string& file) {
  constexpr int kDeepest = 64;  // what armcal writes has less than ten levels
  const auto is_shallow = [](int depth, Json::parse_event_t /*event*/, Json& /*value*/) {
    if (depth > kDeepest) throw std::length_error("nested deeper than any result");
    return true;
  };
  try {
    return Json::parse(document, is_shallow);
  } catch (const Json::parse_error& error) {
    refuse(file, fmt::format("is not JSON (at byte {})", error.byte));
  } catch (const Json::exception&) {
    refuse(file, "holds a number that is too large");
  } catch (const std::length_error& error) {
    refuse(file, fmt::format("is {}", error.what()));
  }
}

}  // namespace

SavedResult load_saved_result(InputFiles& files, const std::string& path) {
  const auto text = files.text(path, kLargestTable_bytes);
  files.require_good();
  const std::size_t first = text->text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string::npos || text->text[first] != '<') return {text->text, {}, {}};
  auto document = document_in_html(text->text);
  if (!document) refuse(path, "is a web page, but no report of armcal");
  const auto stated = sha256_in_html(text->text);
  if (stated && *stated != sha256_hex(*document)) {
    files.diagnostics().warning(
        {path, 0, 0}, "its result was changed after the report was made",
        "what the page shows may be something else: ask who made it for the report as it was");
  }
  SavedResult saved{std::move(*document), {}, language_in_html(text->text)};
  if (auto details = details_in_html(text->text)) {
    saved.details = TextFile{path + " (its details)", std::move(*details), text->encoding, ""};
  }
  return saved;
}

ReportDetails kept_details(InputFiles& files, const SavedResult& saved) {
  if (!saved.details) return {};
  auto details = read_report_details(*saved.details, files.diagnostics());
  if (!details) {
    files.diagnostics().error({saved.details->path, 0, 0}, "are not such as are read today",
                              "give others: --details FILE");
  }
  files.require_good();
  return std::move(*details);
}

ReportDetails load_report_details(InputFiles& files, const std::string& path) {
  const auto text = files.text(path, kLargestConfiguration_bytes);
  files.require_good();
  auto details = read_report_details(*text, files.diagnostics());
  files.require_good();
  return std::move(*details);
}

std::string html_report(const std::string& document, const std::string& file,
                        std::string_view language, const ReportDetails& details) {
  const Json json = parsed(document, file);
  const Language& words = Language::named(language);
  return html_of(page_of(DocumentView(json, file), words, details), words, document,
                 details.source);
}

}  // namespace armcal
