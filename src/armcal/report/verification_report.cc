// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/verification_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"
#include "armcal/report/text_table.h"

namespace armcal {
namespace {

constexpr std::array kBudgetSources = {UncertaintySource::certificate, UncertaintySource::form,
                                       UncertaintySource::temperature, UncertaintySource::expansion,
                                       UncertaintySource::repeatability};

// A seat is no artefact: where nothing is known to be uncertain, nothing is claimed to be exact.
std::string uncertainty_cell(const std::optional<double>& U_mm) {
  return U_mm && *U_mm > 0.0 ? fixed(*U_mm, 4) : "-";
}

std::string length_cell(const std::optional<double>& mm) { return mm ? fixed(*mm, 4) : "-"; }

std::string verdict_cell(Verdict verdict) {
  return verdict == Verdict::not_judged ? "-" : std::string(to_string(verdict));
}

// What is compared with the limit; without one, the result.
std::optional<double> value_of(const Judged& judged) {
  return judged.value_mm ? judged.value_mm : judged.result.value_mm;
}

// The part that the value is of.
const ResultPart* deciding_part(const Judged& judged) {
  const std::vector<ResultPart>& parts = judged.result.parts;
  if (judged.deciding_part) return &parts[*judged.deciding_part];
  const auto at = std::find_if(parts.begin(), parts.end(), [&](const ResultPart& part) {
    return judged.result.value_mm == part.value_mm;
  });
  return at == parts.end() ? nullptr : &*at;
}

// Where the limit depends on the length, the two arms may be decided by different lengths.
bool have_limits_of_their_own(const Verification& verification) {
  return std::any_of(verification.statistics.begin(), verification.statistics.end(),
                     [](const VerifiedStatistic& statistic) {
                       return statistic.as_left &&
                              statistic.as_found.mpe_mm != statistic.as_left->mpe_mm;
                     });
}

std::string table_of_tests(const Verification& verification) {
  const bool both = !verification.as_left_file.empty();
  const bool own_limits = have_limits_of_their_own(verification);
  std::vector<TextTable::Column> columns = {{"test", Align::left}, {"symbol", Align::left}};
  if (both) {
    columns.push_back({"as found mm"});
    if (own_limits) columns.push_back({"MPE mm"});
    columns.insert(columns.end(), {{"verdict"}, {"as left mm"}});
  } else {
    columns.push_back({"value mm"});
  }
  columns.insert(columns.end(), {{"MPE mm"}, {"U mm"}, {"verdict"}});
  TextTable table(columns);
  for (const VerifiedStatistic& statistic : verification.statistics) {
    const Judged& judged = statistic.judged();
    const std::string& symbol = judged.result.symbol;
    std::vector<std::string> cells = {statistic.title, symbol.empty() ? "-" : symbol};
    if (both) {
      const bool has_both = statistic.as_left.has_value();
      cells.push_back(length_cell(value_of(statistic.as_found)));
      if (own_limits) cells.push_back(length_cell(statistic.as_found.mpe_mm));
      cells.insert(cells.end(), {verdict_cell(statistic.as_found.verdict),
                                 has_both ? length_cell(value_of(judged)) : "-"});
    } else {
      cells.push_back(length_cell(value_of(judged)));
    }
    cells.insert(cells.end(), {length_cell(judged.mpe_mm), uncertainty_cell(judged.U_mm),
                               verdict_cell(judged.verdict)});
    table.add_row(std::move(cells));
  }
  return table.text();
}

std::string head_of(const Verification& verification) {
  std::string text =
      fmt::format("Verification{}{} to {}: {}\n", verification.name.empty() ? "" : " of ",
                  verification.name, verification.standard, to_string(verification.verdict()));
  if (verification.arm_file.empty()) {
    text += "  coordinates of the arm's own software\n";
  } else if (verification.as_left_file.empty()) {
    text += fmt::format("  arm            {}\n", verification.arm_file);
  } else {
    text += fmt::format("  arm as found   {}: {}\n  arm as left    {}: {}\n", verification.arm_file,
                        to_string(verification.as_found_verdict()), verification.as_left_file,
                        to_string(verification.verdict()));
  }
  text += fmt::format("  decision rule  {}, k = {}: {}\n", to_string(verification.rule.kind),
                      verification.coverage_factor, explain(verification.rule.kind));
  return text;
}

// What is missing, once for statistics that share it.
std::string missing_text(const Verification& verification) {
  std::set<std::string> told;
  std::string text;
  for (const VerifiedStatistic& statistic : verification.statistics) {
    for (const std::string& missing : statistic.judged().result.missing) {
      const std::string line = fmt::format("  {}: {}\n", statistic.test, missing);
      if (told.insert(line).second) text += line;
    }
  }
  return text.empty() ? text : "\nIncomplete: not a test of the standard\n" + text;
}

std::string not_performed_text(const Verification& verification) {
  if (verification.not_performed.empty()) return {};
  return fmt::format("\nTests of the standard that were not performed: {}\n",
                     fmt::join(verification.not_performed, ", "));
}

std::string deciding_line(const VerifiedStatistic& statistic, const Judged& judged,
                          const char* whose) {
  const ResultPart* part = deciding_part(judged);
  if (part == nullptr) return {};
  std::string line = fmt::format("  {}{}: {}", statistic.title, whose, part->name);
  if (!part->where.empty()) line += fmt::format(" (from {})", part->where);
  if (!statistic.limit.empty()) line += fmt::format(", limit {}", statistic.limit);
  return line + '\n';
}

std::string deciding_text(const Verification& verification) {
  std::string text;
  for (const VerifiedStatistic& statistic : verification.statistics) {
    if (statistic.as_left) {
      text += deciding_line(statistic, statistic.as_found, ", as found");
      text += deciding_line(statistic, *statistic.as_left, ", as left");
    } else {
      text += deciding_line(statistic, statistic.as_found, "");
    }
  }
  return text.empty() ? text : "\nWhat decides\n" + text;
}

std::string definitions_text(const Verification& verification) {
  std::set<std::string> told;
  std::string text = "\nDefinitions\n";
  for (const VerifiedStatistic& statistic : verification.statistics) {
    const TestResult& result = statistic.judged().result;
    if (told.insert(result.definition).second) {
      text += fmt::format("  {}: {}\n", result.name, result.definition);
    }
  }
  return text;
}

// Contributions of one source together, um.
std::string source_cell(const TestUncertainty& budget, UncertaintySource source) {
  double sum_of_squares = 0.0;
  bool any = false;
  for (const UncertaintyContribution& contribution : budget.contributions) {
    if (contribution.source != source) continue;
    any = true;
    sum_of_squares += contribution.u_mm() * contribution.u_mm();
  }
  return any ? fixed(micrometres_from_millimetres(std::sqrt(sum_of_squares)), 2) : "-";
}

std::string budgets_text(const Verification& verification) {
  std::vector<TextTable::Column> columns = {{"test", Align::left}, {"of", Align::left}};
  for (const UncertaintySource source : kBudgetSources) {
    columns.push_back({std::string(to_string(source))});
  }
  columns.insert(columns.end(), {{"u"}, {"U"}});
  TextTable table(columns);
  for (const VerifiedStatistic& statistic : verification.statistics) {
    for (const TestBudget& budget : statistic.budgets) {
      if (budget.uncertainty.contributions.empty()) continue;
      std::vector<std::string> cells = {statistic.title, budget.of};
      for (const UncertaintySource source : kBudgetSources) {
        cells.push_back(source_cell(budget.uncertainty, source));
      }
      const double u_um = micrometres_from_millimetres(budget.uncertainty.combined_mm());
      cells.insert(cells.end(), {fixed(u_um, 2), fixed(verification.coverage_factor * u_um, 2)});
      table.add_row(std::move(cells));
    }
  }
  return table.empty() ? std::string() : "\nUncertainty of the tests, um\n" + table.text();
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json json_of_part(const ResultPart& part, const std::optional<MaximumPermissibleError>& mpe) {
  const bool has_limit = mpe && part.length_mm;
  return {{"name", part.name},
          {"value_mm", json_number(part.value_mm)},
          {"length_mm", json_of(part.length_mm)},
          {"mpe_mm", has_limit ? json_number(mpe->at(*part.length_mm)) : Json(nullptr)},
          {"readings", part.readings},
          {"where", part.where}};
}

// By how much inside its limit a value has to lie to pass.
std::optional<double> guard_of(const Judged& judged, const Verification& verification) {
  if (!judged.U_mm || !judged.mpe_mm) return std::nullopt;
  return guard_band(verification.rule,
                    {*judged.U_mm / verification.coverage_factor, verification.coverage_factor});
}

// The keys that a value of one arm has.
Json json_of_judged(const Judged& judged, const VerifiedStatistic& statistic,
                    const Verification& verification) {
  Json json;
  json["symbol"] = judged.result.symbol.empty() ? Json(nullptr) : Json(judged.result.symbol);
  json["value_mm"] = json_of(value_of(judged));
  json["largest_mm"] = json_of(judged.result.value_mm);
  json["mpe_mm"] = json_of(judged.mpe_mm);
  json["U_mm"] = json_of(judged.U_mm);
  json["guard_mm"] = json_of(guard_of(judged, verification));
  json["share_of_mpe"] = json_of(judged.share_of_mpe);
  json["conformance_probability"] = json_of(judged.conformance_probability);
  json["verdict"] = to_string(judged.verdict);
  json["complete"] = judged.result.complete();
  json["missing"] = judged.result.missing;
  const ResultPart* part = deciding_part(judged);
  json["decided_by"] = part == nullptr ? Json(nullptr) : Json(part->name);
  json["parts"] = Json::array();
  for (const ResultPart& each : judged.result.parts) {
    json["parts"].push_back(json_of_part(each, statistic.mpe));
  }
  return json;
}

Json json_of_budget(const TestBudget& budget, double coverage_factor) {
  Json json;
  json["of"] = budget.of.empty() ? Json(nullptr) : Json(budget.of);
  json["contributions"] = Json::array();
  for (const UncertaintyContribution& contribution : budget.uncertainty.contributions) {
    json["contributions"].push_back({{"name", contribution.name},
                                     {"source", to_string(contribution.source)},
                                     {"u", contribution.u},
                                     {"unit", contribution.unit},
                                     {"sensitivity", contribution.sensitivity},
                                     {"u_mm", contribution.u_mm()}});
  }
  json["u_mm"] = budget.uncertainty.combined_mm();
  json["U_mm"] = coverage_factor * budget.uncertainty.combined_mm();
  return json;
}

Json json_of_statistic(const VerifiedStatistic& statistic, const Verification& verification) {
  Json json;
  const TestResult& result = statistic.judged().result;
  json["name"] = result.name;
  json["test"] = statistic.test;
  json["title"] = statistic.title;
  json["definition"] = result.definition;
  json["is_signed"] = result.is_signed;
  json["artefact"] = text_or_null(statistic.artefact);
  json["limit"] = text_or_null(statistic.limit);
  json.update(json_of_judged(statistic.judged(), statistic, verification));
  if (statistic.as_left) {
    json["as_found"] = json_of_judged(statistic.as_found, statistic, verification);
    json["as_left"] = json_of_judged(*statistic.as_left, statistic, verification);
  }
  json["budgets"] = Json::array();
  for (const TestBudget& budget : statistic.budgets) {
    json["budgets"].push_back(json_of_budget(budget, verification.coverage_factor));
  }
  return json;
}

// What its certificate says of it.
Json json_of_artefact(const StatedArtefact& artefact) {
  Json json = {{"name", artefact.name},
               {"kind", artefact.is_sphere ? "sphere" : "lengths"},
               {"certificate", text_or_null(artefact.certificate)},
               {"coverage_factor", artefact.coverage_factor},
               {"expansion_per_K", artefact.expansion_per_K},
               {"u_expansion_per_K", artefact.u_expansion_per_K}};
  if (artefact.is_sphere) {
    json["diameter_mm"] = artefact.diameter_mm;
    json["U_mm"] = artefact.U_mm;
    json["form_mm"] = artefact.form_mm;
    return json;
  }
  json["lengths"] = Json::array();
  for (const CertifiedLength& length : artefact.lengths) {
    json["lengths"].push_back(
        {{"name", length.name}, {"length_mm", length.length_mm}, {"U_mm", length.U_mm}});
  }
  return json;
}

}  // namespace

Json json_result(const Verification& verification) {
  Json json;
  json["name"] = verification.name;
  json["standard"] = verification.standard;
  json["arm"] = text_or_null(verification.arm_file);
  json["as_left_arm"] = text_or_null(verification.as_left_file);
  json["reach_mm"] = json_of(verification.reach_mm);
  json["decision"] = {{"rule", to_string(verification.rule.kind)},
                      {"coverage_factor", verification.coverage_factor},
                      {"probability", verification.rule.probability},
                      {"guard_factor", verification.rule.guard_factor}};
  json["environment"] = {{"temperature_C", verification.environment.temperature_C},
                         {"u_temperature_K", verification.environment.u_temperature_K}};
  json["artefacts"] = Json::array();
  for (const StatedArtefact& artefact : verification.artefacts) {
    json["artefacts"].push_back(json_of_artefact(artefact));
  }
  json["not_performed"] = verification.not_performed;
  json["tests"] = Json::array();
  for (const VerifiedStatistic& statistic : verification.statistics) {
    json["tests"].push_back(json_of_statistic(statistic, verification));
  }
  json["verdict"] = to_string(verification.verdict());
  if (!verification.as_left_file.empty()) {
    json["as_found_verdict"] = to_string(verification.as_found_verdict());
  }
  return json;
}

std::string text_result(const Verification& verification) {
  return head_of(verification) + "\n" + table_of_tests(verification) + missing_text(verification) +
         not_performed_text(verification) + deciding_text(verification) +
         definitions_text(verification) + budgets_text(verification);
}

}  // namespace armcal
