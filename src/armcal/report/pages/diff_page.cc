// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/diff_page.h"

#include <algorithm>
#include <cmath>

#include "armcal/report/chart/interval_chart.h"
#include "armcal/report/number_format.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr int kDecimalsWithoutU = 6;  // of what neither calibration estimated

// Neither estimated nor moved.
bool is_idle(const DocumentView& change) {
  return change.number("u") == 0.0 && change.number("change") == 0.0;
}

Cell diff_remark(const DocumentView& change, const Language& say) {
  if (change.flag("held_in_one")) return {say("diff.held_in_one")};
  if (change.flag("changed")) return {say("diff.changed"), Tone::warning};
  return {""};
}

Table changes_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("diff.caption");
  table.columns = {{say("parameters.name"), ColumnKind::text},
                   {say("diff.before")},
                   {say("diff.after")},
                   {say("parameters.change")},
                   {"u"},
                   {say("parameters.unit"), ColumnKind::word},
                   {say("diff.ratio")},
                   {say("compare.remark"), ColumnKind::prose}};
  for (const DocumentView& change : document.list("changes")) {
    if (is_idle(change)) continue;
    const ShownUnit shown = shown_unit(change.text("name"), change.text("unit"));
    const double u = shown.factor * change.number("u");
    const int decimals = u > 0.0 ? decimals_for_uncertainty(u) : kDecimalsWithoutU;
    const auto ratio = change.number_if("ratio");
    table.rows.push_back({{change.text("name")},
                          {fixed(shown.factor * change.number("before"), decimals)},
                          {fixed(shown.factor * change.number("after"), decimals)},
                          {fixed(shown.factor * change.number("change"), decimals)},
                          {fixed(u, decimals)},
                          {shown.unit},
                          {ratio ? fixed(*ratio, 1) : "\u2013"},
                          diff_remark(change, say)});
  }
  table.note = say("diff.note");
  return table;
}

// In units of u, so that all stand on one axis; the interval is that of 95 %.
Figure ratios_of(const DocumentView& document, const Language& say) {
  IntervalChart chart;
  chart.id = "changes-over-u";
  chart.title = say("diff.figure");
  chart.text = say("diff.figure_text");
  chart.nothing = say("figures.no_parameters");
  chart.estimated = say("figures.estimated");
  chart.held = say("diff.held_in_one");
  IntervalGroup group{say("diff.ratio"), {}};
  for (const DocumentView& change : document.list("changes")) {
    const auto ratio = change.number_if("ratio");
    if (is_idle(change) || !ratio) continue;
    group.rows.push_back(
        {change.text("name"), *ratio, 2.0, fixed(*ratio, 1), change.flag("held_in_one")});
  }
  chart.groups.push_back(std::move(group));
  return figure_of(chart);
}

}  // namespace

Page diff_page(const DocumentView& document, const Language& say) {
  const std::vector<DocumentView> changes = document.list("changes");
  const auto changed =
      std::count_if(changes.begin(), changes.end(),
                    [](const DocumentView& change) { return change.flag("changed"); });
  Page page;
  page.title = say("diff.title");
  if (document.has("before")) {
    page.subtitle = fmt::format("{} \u2192 {}", document.text("before"), document.text("after"));
  }
  page.stamp = changed == 0 ? Stamp{say("diff.same"), say("diff.same_sentence"), Tone::good}
                            : Stamp{say("diff.different"), say("diff.different_sentence", changed),
                                    Tone::warning};
  page.sections.push_back({"changes",
                           say("diff.caption"),
                           say("diff.lead"),
                           {changes_table(document, say), Figures{{ratios_of(document, say)}}}});
  return page;
}

}  // namespace armcal
