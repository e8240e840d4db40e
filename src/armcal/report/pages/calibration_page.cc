// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/pages/calibration_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "armcal/report/calibration_quality.h"
#include "armcal/report/number_format.h"
#include "armcal/report/pages/calibration_figures.h"
#include "armcal/report/pages/parameter_table.h"
#include "armcal/report/pages/verdict_words.h"
#include "armcal/report/shown_number.h"

namespace armcal {
namespace {

constexpr std::size_t kWorstRows = 10;
constexpr double kPromised = 0.95;  // share of held-out rows in their predicted regions

// Root mean square over all groups of one kind of statistics.
struct Pooled {
  double squares = 0.0;
  double count = 0.0;
  void add(const DocumentView& statistics, std::string_view key) {
    const double n = statistics.number("count");
    const double rms = statistics.number(key);
    squares += n * rms * rms;
    count += n;
  }
  [[nodiscard]] double rms_mm() const { return std::sqrt(squares / count); }
};

struct Quality {
  Pooled nominal, fit, check, fit_floor, check_floor;
  std::optional<double> coverage;
  double sigma0 = 1.0;
  std::size_t flagged = 0;     // rows
  bool scatters_more = false;  // than stated
  bool model_too_small = false;
};

Quality quality_of(const DocumentView& document) {
  Quality quality;
  for (const DocumentView& group : document.list("groups")) {
    if (group.number("count") > 0) quality.fit.add(group, "rms_mm");
    if (group.has("floor_mm")) quality.fit_floor.add(group, "floor_mm");
    if (group.has("nominal")) quality.nominal.add(group["nominal"], "rms_mm");
    if (!group.has("check")) continue;
    quality.check.add(group["check"], "rms_mm");
    if (group["check"].has("floor_mm")) quality.check_floor.add(group["check"], "floor_mm");
  }
  quality.coverage = document.number_if("check_coverage");
  quality.sigma0 = document.number("sigma0");
  quality.flagged = document.list("flagged").size();
  quality.scatters_more =
      document.number("dof") > 0 &&
      scatters_more_than_stated(quality.sigma0, document.number("chi2_probability"));
  quality.model_too_small = quality.coverage && is_model_too_small(*quality.coverage);
  return quality;
}

Stamp calibration_stamp(const Quality& quality, const Language& say) {
  std::vector<std::string> reservations;
  if (quality.model_too_small) {
    reservations.push_back(say("calibration.model_too_small", fixed(100.0 * *quality.coverage, 1)));
  } else if (quality.scatters_more) {
    reservations.push_back(say("calibration.scatters_more", fixed(quality.sigma0, 3)));
  }
  if (quality.flagged > 0) {
    reservations.push_back(say("calibration.flagged_sentence", quality.flagged));
  }
  if (reservations.empty()) {
    return {say("calibration.converged"), say("calibration.converged_sentence"), Tone::good};
  }
  return {say("calibration.with_reservation"), run_on(reservations, say), Tone::warning};
}

Headlines calibration_headlines(const Quality& quality, const DocumentView& document,
                                const Language& say) {
  Headlines headlines;
  const auto add = [&](const char* label, const Pooled& pooled, const char* note) {
    if (pooled.count == 0.0) return;
    headlines.items.push_back(
        {say(label), fixed(pooled.rms_mm(), 4), "mm", say(note, pooled.count), Tone::neutral});
  };
  add("calibration.before", quality.nominal, "calibration.before_note");
  add("calibration.after", quality.fit, "calibration.after_note");
  add("calibration.held_out", quality.check, "calibration.held_out_note");
  // Of the rows that are judged by.
  add("calibration.floor", quality.check.count > 0.0 ? quality.check_floor : quality.fit_floor,
      quality.check.count > 0.0 ? "calibration.floor_note" : "calibration.floor_of_fit_note");
  headlines.items.push_back({say("calibration.sigma0"), fixed(quality.sigma0, 3), "",
                             say("calibration.sigma0_note", document.number("dof")),
                             quality.scatters_more ? Tone::warning : Tone::neutral});
  if (quality.coverage) {
    headlines.items.push_back(
        {say("calibration.coverage"), fixed(100.0 * *quality.coverage, 1), "%",
         say("calibration.coverage_note", fixed(100.0 * kPromised, 0), quality.check.count),
         quality.model_too_small ? Tone::warning : Tone::neutral});
  }
  return headlines;
}

void add_group_row(Table& table, const DocumentView& group, const std::string& rows,
                   const DocumentView& statistics, const Language& say) {
  const std::string kind = group.text("kind");
  const std::string kind_key = fmt::format("calibration.kind_of.{}", kind);
  table.rows.push_back({{group.text("name")},
                        {say.has(kind_key) ? say(kind_key) : kind},
                        {rows},
                        {whole(statistics.number("count"))},
                        {fixed(statistics.number("rms_mm"), 4)},
                        {fixed(statistics.number("mean_mm"), 4)},
                        {fixed(statistics.number("max_mm"), 4)}});
}

Table groups_table(const DocumentView& document, const Language& say) {
  Table table;
  table.caption = say("calibration.groups");
  table.columns = {{say("calibration.readings"), ColumnKind::text},
                   {say("calibration.kind"), ColumnKind::text},
                   {say("calibration.rows"), ColumnKind::text},
                   {say("calibration.count")},
                   {say("calibration.rms")},
                   {say("calibration.mean")},
                   {say("calibration.max")}};
  for (const DocumentView& group : document.list("groups")) {
    if (group.number("count") > 0) {
      if (group.has("nominal")) {
        add_group_row(table, group, say("calibration.rows_nominal"), group["nominal"], say);
      }
      add_group_row(table, group, say("calibration.rows_fitted"), group, say);
    }
    if (group.has("check")) {
      add_group_row(table, group, say("calibration.rows_held_out"), group["check"], say);
    }
    if (group.has("check_registered") && group.text("kind") != "length") {
      add_group_row(table, group, say("calibration.rows_placed_anew"), group["check_registered"],
                    say);
    }
  }
  table.note = say("calibration.groups_note");
  return table;
}

Section calibration_summary_section(const DocumentView& document, const Quality& quality,
                                    const Language& say) {
  Section section{"summary", say("calibration.summary"), "", {}};
  section.blocks.push_back(calibration_headlines(quality, document, say));
  section.blocks.push_back(groups_table(document, say));
  return section;
}

// Names of what moves readings alike, the strongest first, as `describe` of arm/estimability does.
std::string strongest_names(const DocumentView& combination, const std::string& held,
                            const Language& say) {
  constexpr double kNegligible = 1e-3;
  constexpr std::size_t kNamed = 4;
  std::vector<std::pair<double, std::string>> parts;
  double largest = 0.0;
  for (const auto& [name, weight] : combination.json().items()) {
    if (name == held) continue;
    parts.emplace_back(std::abs(combination.number(name)), name);
    largest = std::max(largest, parts.back().first);
  }
  std::erase_if(parts, [&](const auto& part) { return !(part.first > kNegligible * largest); });
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamed, parts.size()); ++i) names.push_back(parts[i].second);
  if (parts.size() <= kNamed) return listed(names, say);
  return say("calibration.and_more", listed(names, say), parts.size() - kNamed);
}

// Both languages say it from the combination; other reasons stand as the document words them.
std::string unseen_text(const DocumentView& direction, const Language& say) {
  const std::string held = direction.text("held");
  const std::string like = strongest_names(direction["combination"], held, say);
  return like.empty() ? direction.text("description") : say("calibration.unseen_like", held, like);
}

// Estimated, but more from what was known before than from the readings.
std::string known_from_priors(const DocumentView& document, const Language& say) {
  constexpr double kHalf = 0.5;
  std::vector<std::string> names;
  for (const DocumentView& parameter : document.list("parameters")) {
    if (parameter.text("status") != "prior" || parameter.number("data_share") >= kHalf) continue;
    names.push_back(parameter.text("name"));
  }
  return listed(names, say);
}

Section calibration_unseen_section(const DocumentView& document, const Language& say) {
  Section section{"unseen", say("calibration.unseen"), "", {}};
  Notice notice{Tone::neutral, say("calibration.unseen_lead"), {}};
  for (const DocumentView& direction : document.list("null_space")) {
    notice.lines.push_back(unseen_text(direction, say));
  }
  section.blocks.push_back(notice.lines.empty() ? Block(Paragraph{say("calibration.all_seen")})
                                                : Block(notice));
  if (const std::string names = known_from_priors(document, say); !names.empty()) {
    section.blocks.emplace_back(Notice{Tone::neutral, say("calibration.from_priors"), {names}});
  }
  return section;
}

Table worst_rows(const std::vector<ResidualRow>& rows, const Language& say) {
  Table table;
  table.caption = say("calibration.worst_rows");
  table.columns = {{say("calibration.place"), ColumnKind::prose},
                   {say("calibration.readings"), ColumnKind::text},
                   {say("calibration.residual")},
                   {say("calibration.normalised")},
                   {say("calibration.u")},
                   {say("calibration.set"), ColumnKind::text}};
  std::vector<const ResidualRow*> order;
  for (const ResidualRow& row : rows) order.push_back(&row);
  std::stable_sort(order.begin(), order.end(),
                   [](const ResidualRow* one, const ResidualRow* other) {
                     return std::abs(one->normalised) > std::abs(other->normalised);
                   });
  order.resize(std::min(kWorstRows, order.size()));
  for (const ResidualRow* row : order) {
    table.rows.push_back({{row->place},
                          {row->group},
                          {fixed(row->residual_mm, 4)},
                          {fixed(row->normalised, 2)},
                          {fixed(row->u_mm, 4)},
                          {say(row->is_check ? "calibration.set_check" : "calibration.set_fit")}});
  }
  return table;
}

Notice flagged_rows(const DocumentView& document, const Language& say) {
  Notice notice{Tone::warning, say("calibration.flagged"), {}};
  for (const DocumentView& row : document.list("flagged")) {
    notice.lines.push_back(say("calibration.flagged_row", row.text("file"),
                               whole(row.number("line")), fixed(row.number("residual_mm"), 3),
                               fixed(row.number("normalised"), 1)));
  }
  return notice;
}

Section residuals_section(const DocumentView& document, const std::vector<ResidualRow>& rows,
                          const Language& say) {
  Section section{"residuals", say("calibration.residuals"), say("calibration.residuals_lead"), {}};
  Notice flagged = flagged_rows(document, say);
  if (!flagged.lines.empty()) section.blocks.emplace_back(std::move(flagged));
  if (rows.empty()) {
    section.blocks.emplace_back(Paragraph{say("calibration.no_rows")});
    return section;
  }
  section.blocks.emplace_back(worst_rows(rows, say));
  section.blocks.emplace_back(residual_figures(rows, say));
  return section;
}

// @param lead  its key: what was, or can be, estimated
Section parameters_section(const DocumentView& document, const char* lead, Table table,
                           const Language& say) {
  const std::string condition = condition_text(document.number_if("condition_number"));
  return {"parameters",
          say("parameters.title"),
          say(lead, whole(document.number("rank")), whole(document.number("unknowns")), condition),
          {std::move(table)}};
}

}  // namespace

Page calibration_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("calibration.title");
  page.subtitle = document.text("arm_name");
  const Quality quality = quality_of(document);
  page.stamp = calibration_stamp(quality, say);
  const std::vector<ResidualRow> rows =
      document.has("rows") ? residual_rows(document) : std::vector<ResidualRow>();
  page.sections.push_back(calibration_summary_section(document, quality, say));
  if (!rows.empty()) page.sections.push_back(arm_section(document, rows, say));
  page.sections.push_back(
      parameters_section(document, "parameters.lead", parameter_table(document, say), say));
  page.sections.back().blocks.emplace_back(parameter_changes(document, say));
  page.sections.push_back(calibration_unseen_section(document, say));
  page.sections.push_back(residuals_section(document, rows, say));
  if (!rows.empty()) page.sections.push_back(coverage_section(document, rows, say));
  page.sections.push_back(numerics_section(document, say));
  return page;
}

Page identifiability_page(const DocumentView& document, const Language& say) {
  Page page;
  page.title = say("identifiability.title");
  page.subtitle = document.text("arm_name");
  page.sections = {parameters_section(document, "parameters.lead_of_expected",
                                      expected_parameter_table(document, say), say),
                   calibration_unseen_section(document, say)};
  return page;
}

}  // namespace armcal
