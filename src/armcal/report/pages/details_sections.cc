// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/details_sections.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/core/spelling.h"

namespace armcal {
namespace {

// Parts of one entry that are there, with commas between them.
std::string joined_parts(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += fmt::format("{}{}", text.empty() ? "" : ", ", part);
  }
  return text;
}

Table references_table(const std::vector<ReferenceStandard>& references, const Language& say) {
  Table table;
  table.caption = say("details.references");
  for (const char* key : {"details.name", "details.serial", "details.certificate",
                          "details.traceable_to", "details.u_of_reference", "details.due"}) {
    table.columns.push_back({say(key), ColumnKind::text});
  }
  for (const ReferenceStandard& each : references) {
    table.rows.push_back({{each.name},
                          {each.serial},
                          {each.certificate},
                          {each.traceable_to},
                          {each.uncertainty},
                          {each.due}});
  }
  return table;
}

Table externals_table(const std::vector<ExternalProvider>& externals, const Language& say) {
  Table table;
  table.caption = say("details.externals");
  table.columns = {{say("details.external_name"), ColumnKind::text},
                   {say("details.external_results"), ColumnKind::text}};
  for (const ExternalProvider& each : externals) {
    table.rows.push_back({{each.name}, {each.results}});
  }
  return table;
}

bool is_empty(const Facts& facts) {
  for (const auto& [name, value] : facts.rows) {
    if (!value.empty()) return false;
  }
  return true;
}

// A line of the command as it can be typed again.
std::string typed_again(const std::vector<std::string>& words) {
  std::string line = "armcal";
  for (const std::string& word : words) line += " " + shell_word(word);
  return line;
}

std::string place_of(const DocumentView& warning) {
  std::string place = warning.text_if("file").value_or("");
  if (const auto line = warning.number_if("line")) place += fmt::format(":{:.0f}", *line);
  return place;
}

}  // namespace

void add_details(const ReportDetails& details, const Language& say, Page& page) {
  const ReportDetails::Item& item = details.item;
  Facts head{
      {{say("details.replaces"), details.replaces},
       {say("details.laboratory"),
        joined_parts({details.laboratory.name, details.laboratory.address})},
       {say("details.accreditation"), details.laboratory.accreditation},
       {say("details.place"), details.place},
       {say("details.customer"), joined_parts({details.customer.name, details.customer.address})},
       {say("details.item"), joined_parts({item.description, item.maker, item.model})},
       {say("details.serial"), item.serial},
       {say("details.probe"), item.probe},
       {say("details.condition"), item.condition},
       {say("details.received"), details.dates.received},
       {say("details.performed"), details.dates.performed},
       {say("details.issued"), details.dates.issued}}};
  page.head.rows.insert(page.head.rows.begin(), head.rows.begin(), head.rows.end());

  const Facts conditions{
      {{say("details.temperature"), details.environment.temperature},
       {say("details.humidity"), details.environment.humidity},
       {say("details.mounting"), details.environment.mounting},
       {say("details.remarks"), details.environment.remarks},
       {say("details.method"), joined_parts({details.method.name, details.method.edition})},
       {say("details.deviations"), details.method.deviations},
       {say("details.uncertainty"), details.statements.uncertainty},
       {say("details.decision_rule"), details.statements.decision_rule},
       {say("details.statement_remarks"), details.statements.remarks}}};
  Section section{"conditions", say("details.title"), "", {}};
  if (!is_empty(conditions)) section.blocks.push_back(conditions);
  if (!details.references.empty()) {
    section.blocks.push_back(references_table(details.references, say));
  }
  if (!details.externals.empty()) {
    section.blocks.push_back(externals_table(details.externals, say));
  }
  const auto& [name, role] = details.released_by;
  const bool is_released = !name.empty() || !role.empty();
  if (section.blocks.empty() && is_empty(head) && !is_released) return;
  section.blocks.push_back(Paragraph{say("details.only_this_item")});
  if (is_released) section.blocks.push_back(Signature{say("details.released_by"), name, role});
  page.sections.push_back(std::move(section));
}

Section origin_section(const DocumentView& document, const Language& say) {
  Section section{"origin", say("origin.title"), say("origin.lead"), {}};
  Facts facts{{{say("origin.version"), document.text_if("tool_version").value_or("")},
               {say("origin.seed"), document.has("seed") ? document["seed"].json().dump() : ""}}};
  section.blocks.push_back(facts);
  if (document.has("command_line")) {
    section.blocks.push_back(Verbatim{typed_again(document.texts("command_line"))});
  }
  Table inputs;
  inputs.caption = say("origin.inputs");
  inputs.columns = {{say("origin.file"), ColumnKind::prose}, {"SHA-256", ColumnKind::prose}};
  for (const DocumentView& each : document.list("inputs")) {
    inputs.rows.push_back({{each.text("path")}, {each.text("sha256")}});
  }
  if (!inputs.rows.empty()) section.blocks.push_back(inputs);
  Notice warnings{Tone::warning, say("origin.warnings"), {}};
  for (const DocumentView& each : document.list("warnings")) {
    const std::string place = place_of(each);
    warnings.lines.push_back(
        fmt::format("{}{}{}", place, place.empty() ? "" : ": ", each.text("message")));
  }
  if (!warnings.lines.empty()) section.blocks.push_back(warnings);
  return section;
}

}  // namespace armcal
