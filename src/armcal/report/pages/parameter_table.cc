// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/parameter_table.h"

#include <fmt/format.h>

#include "armcal/report/number_format.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr int kDecimalsOfHeld = 4;

enum class Stage { expected, calibrated };

std::vector<Cell> parameter_row(const DocumentView& parameter, Stage stage, const Language& say) {
  const ShownUnit shown = shown_unit(parameter.text("name"), parameter.text("unit"));
  const std::string status = parameter.text("status");
  const bool held = status == "held";
  const double u = shown.factor * parameter.number("u");
  const double nominal = shown.factor * parameter.number("nominal");
  const double value = shown.factor * parameter.number("value");
  const int decimals = held ? kDecimalsOfHeld : decimals_for_uncertainty(u);
  std::vector<Cell> row = {{parameter.text("name")}, {fixed(nominal, decimals)}};
  if (stage == Stage::calibrated) {
    row.push_back({fixed(value, decimals)});
    row.push_back({held ? "" : fixed(value - nominal, decimals)});
  }
  row.insert(row.end(),
             {{held ? "" : fixed(u, decimals)},
              {shown.unit},
              {say(fmt::format("parameters.status_{}", status))},
              {held ? "" : fmt::format("{:.0f} %", 100.0 * parameter.number("data_share"))}});
  return row;
}

Table table_of_parameters(const DocumentView& document, Stage stage, const Language& say) {
  Table table;
  table.caption = say("parameters.caption");
  table.columns = {{say("parameters.name"), ColumnKind::text}, {say("parameters.nominal")}};
  if (stage == Stage::calibrated) {
    table.columns.insert(table.columns.end(),
                         {{say("parameters.value")}, {say("parameters.change")}});
  }
  table.columns.insert(table.columns.end(), {{say("parameters.u")},
                                             {say("parameters.unit"), ColumnKind::word},
                                             {say("parameters.status"), ColumnKind::text},
                                             {say("parameters.data_share")}});
  for (const DocumentView& parameter : document.list("parameters")) {
    const std::string status = parameter.text("status");
    if (status != "held" && status != "free" && status != "prior") {
      parameter["status"].complain("is none of held, free, prior");
    }
    if (status == "held" && parameter.number("value") == 0.0) continue;
    table.rows.push_back(parameter_row(parameter, stage, say));
  }
  table.note = say(stage == Stage::calibrated ? "parameters.note" : "parameters.note_of_expected");
  return table;
}

}  // namespace

Table parameter_table(const DocumentView& document, const Language& say) {
  return table_of_parameters(document, Stage::calibrated, say);
}

Table expected_parameter_table(const DocumentView& document, const Language& say) {
  return table_of_parameters(document, Stage::expected, say);
}

}  // namespace armcal
