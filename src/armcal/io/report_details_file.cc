// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/report_details_file.h"

#include <fmt/format.h>

#include <utility>

#include "armcal/core/utc_time.h"
#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

using Fields = std::vector<std::pair<const char*, std::string*>>;

// Blank is empty, and the end of a text of several lines is no line of its own.
std::string without_trailing_space(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text;
}

// Dates and whole numbers may be typed without quotes. @return is anything there?
bool read_fields(TomlSection& section, const Fields& fields) {
  bool is_filled = false;
  for (const auto& [key, target] : fields) {
    if (auto text = section.spelled(key)) *target = without_trailing_space(std::move(*text));
    is_filled = is_filled || !target->empty();
  }
  return is_filled;
}

void read_section(TomlSection& root, const char* key, const Fields& fields) {
  auto section = root.section(key);
  if (!section) return;
  read_fields(*section, fields);
  section->finish();
}

// A day in ISO form: such days sort as their texts do. Ranges and words are left to the reader.
bool is_iso_day(const std::string& text) {
  constexpr std::size_t kLength = std::string_view("2026-01-31").size();
  return text.size() == kLength && parse_utc_time(text).has_value();
}

void read_dates(TomlSection& root, ReportDetails::Dates& dates, Diagnostics& diagnostics) {
  auto section = root.section("dates");
  if (!section) return;
  const Fields in_order = {
      {"received", &dates.received}, {"performed", &dates.performed}, {"issued", &dates.issued}};
  read_fields(*section, in_order);
  section->finish();
  const Fields::value_type* before = nullptr;
  for (const auto& each : in_order) {
    const auto& [key, day] = each;
    if (!is_iso_day(*day)) continue;
    if (before != nullptr && *day < *before->second) {
      diagnostics.warning(
          section->where(key),
          fmt::format("{} {} is before {} {}", key, *day, before->first, *before->second),
          "is one of them mistyped?");
    }
    before = &each;
  }
}

// @param performed  when the work was done
void read_references(TomlSection& root, const std::string& performed,
                     std::vector<ReferenceStandard>& references, Diagnostics& diagnostics) {
  for (TomlSection& section : root.sections("reference")) {
    ReferenceStandard standard;
    const bool is_filled = read_fields(section, {{"name", &standard.name},
                                                 {"serial", &standard.serial},
                                                 {"certificate", &standard.certificate},
                                                 {"traceable_to", &standard.traceable_to},
                                                 {"uncertainty", &standard.uncertainty},
                                                 {"due", &standard.due}});
    section.finish();
    if (!is_filled) continue;
    if (is_iso_day(standard.due) && is_iso_day(performed) && standard.due < performed) {
      diagnostics.warning(
          section.where("due"),
          fmt::format("due {} of \"{}\" is before performed {}: its calibration counted no more",
                      standard.due, standard.name, performed),
          "name the certificate that counted on that day");
    }
    references.push_back(std::move(standard));
  }
}

void read_externals(TomlSection& root, std::vector<ExternalProvider>& externals) {
  for (TomlSection& section : root.sections("external")) {
    ExternalProvider provider;
    const bool is_filled =
        read_fields(section, {{"name", &provider.name}, {"results", &provider.results}});
    section.finish();
    if (is_filled) externals.push_back(std::move(provider));
  }
}

}  // namespace

std::optional<ReportDetails> read_report_details(const TextFile& file, Diagnostics& diagnostics) {
  const auto document = parse_toml(file, diagnostics);
  if (!document) return std::nullopt;
  const std::size_t before = diagnostics.error_count();
  TomlSection root(*document, diagnostics);
  check_schema(root, "details", diagnostics);
  ReportDetails details;
  details.source = file.text;
  read_fields(root, {{"title", &details.title},
                     {"number", &details.number},
                     {"replaces", &details.replaces},
                     {"place", &details.place}});
  read_section(root, "laboratory",
               {{"name", &details.laboratory.name},
                {"address", &details.laboratory.address},
                {"accreditation", &details.laboratory.accreditation}});
  read_section(root, "customer",
               {{"name", &details.customer.name}, {"address", &details.customer.address}});
  read_section(root, "item",
               {{"description", &details.item.description},
                {"maker", &details.item.maker},
                {"model", &details.item.model},
                {"serial", &details.item.serial},
                {"probe", &details.item.probe},
                {"condition", &details.item.condition}});
  read_dates(root, details.dates, diagnostics);
  read_section(root, "environment",
               {{"temperature", &details.environment.temperature},
                {"humidity", &details.environment.humidity},
                {"mounting", &details.environment.mounting},
                {"remarks", &details.environment.remarks}});
  read_references(root, details.dates.performed, details.references, diagnostics);
  read_externals(root, details.externals);
  read_section(root, "method",
               {{"name", &details.method.name},
                {"edition", &details.method.edition},
                {"deviations", &details.method.deviations}});
  read_section(root, "statements",
               {{"uncertainty", &details.statements.uncertainty},
                {"decision_rule", &details.statements.decision_rule},
                {"remarks", &details.statements.remarks}});
  read_section(root, "released_by",
               {{"name", &details.released_by.name}, {"role", &details.released_by.role}});
  root.finish();
  if (diagnostics.error_count() > before) return std::nullopt;
  return details;
}

}  // namespace armcal
