// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/report_details_file.h"

#include <utility>

#include "armcal/io/toml_value.h"

namespace armcal {
namespace {

using Fields = std::vector<std::pair<const char*, std::string*>>;

// Dates and numbers may be typed without quotes.
void read_fields(TomlSection& section, const Fields& fields) {
  for (const auto& [key, target] : fields) {
    if (auto text = section.spelled(key)) *target = std::move(*text);
  }
}

void read_section(TomlSection& root, const char* key, const Fields& fields) {
  auto section = root.section(key);
  if (!section) return;
  read_fields(*section, fields);
  section->finish();
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
  read_fields(root,
              {{"title", &details.title}, {"number", &details.number}, {"place", &details.place}});
  for (const auto& [key, party] :
       {std::pair{"laboratory", &details.laboratory}, std::pair{"customer", &details.customer}}) {
    read_section(root, key,
                 {{"name", &party->name},
                  {"address", &party->address},
                  {"accreditation", &party->accreditation}});
  }
  read_section(root, "item",
               {{"description", &details.item.description},
                {"maker", &details.item.maker},
                {"model", &details.item.model},
                {"serial", &details.item.serial},
                {"probe", &details.item.probe},
                {"condition", &details.item.condition}});
  read_section(root, "dates",
               {{"received", &details.dates.received},
                {"performed", &details.dates.performed},
                {"issued", &details.dates.issued}});
  read_section(root, "environment",
               {{"temperature", &details.environment.temperature},
                {"humidity", &details.environment.humidity},
                {"mounting", &details.environment.mounting},
                {"remarks", &details.environment.remarks}});
  for (TomlSection& section : root.sections("reference")) {
    ReferenceStandard standard;
    read_fields(section, {{"name", &standard.name},
                          {"serial", &standard.serial},
                          {"certificate", &standard.certificate},
                          {"traceable_to", &standard.traceable_to},
                          {"uncertainty", &standard.uncertainty},
                          {"due", &standard.due}});
    section.finish();
    details.references.push_back(std::move(standard));
  }
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
