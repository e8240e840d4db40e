// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/check_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armcal/core/version.h"
#include "armcal/io/check_history.h"
#include "armcal/io/check_table.h"
#include "armcal/workflow/touched_places.h"

namespace armcal {
namespace {

std::string sha256_of(const InputFiles& files, const std::optional<std::string>& path) {
  for (const InputRecord& record : files.records()) {
    if (path && record.path == *path) return record.sha256;
  }
  return {};
}

// The same series: what one chart shows.
bool belong_together(const CheckRecord& one, const CheckRecord& other) {
  return one.arm == other.arm && one.arm_sha256 == other.arm_sha256 &&
         one.artefact == other.artefact && one.kind == other.kind;
}

InterimCheck measured(InputFiles& files, const CheckRequest& request,
                      const std::optional<ArmModel>& arm, const TableOptions& options) {
  const std::string& file = *request.readings;
  const auto places = touched_places(files, file, arm, options);
  for (const std::string& problem : problems_of(places, request.options)) {
    files.diagnostics().error({file, 0, 0}, problem);
  }
  files.require_good();
  InterimCheck check = check_arm(places, request.options);
  for (const CheckedPlace& place : check.places) {
    if (place.count >= advised_points(check.kind)) continue;
    files.diagnostics().warning(
        {file, 0, 0},
        fmt::format("{} points{}{}: {} show more", place.count, place.name.empty() ? "" : " at ",
                    place.name, advised_points(check.kind)));
  }
  return check;
}

CheckRecord record_of(const InputFiles& files, const CheckRequest& request,
                      const std::string& arm_name, const InterimCheck& check) {
  CheckRecord record;
  record.time = request.time;
  record.arm = arm_name;
  record.arm_sha256 = sha256_of(files, request.arm);
  record.artefact = request.artefact.value_or("");
  record.kind = to_string(check.kind);
  for (const CheckedPlace& place : check.places) {
    record.point_count += static_cast<std::int64_t>(place.count);
  }
  record.temperature_c = request.temperature_c;
  record.verdict = to_string(check.verdict());
  record.readings_sha256 = sha256_of(files, request.readings);
  record.tool_version = kVersion;
  record.note = request.note;
  for (const CheckValue& value : check.values) {
    record.values.push_back({value.name, value.value_mm, value.limit_mm});
  }
  return record;
}

// Typed twice, or tried again after a stop: a check counts once.
void refuse_repeats(const std::vector<CheckRecord>& checks, const CheckRecord& record,
                    InputFiles& files, const CheckRequest& request) {
  for (const CheckRecord& each : checks) {
    if (!belong_together(each, record) || each.readings_sha256 != record.readings_sha256 ||
        each.values != record.values) {
      continue;
    }
    files.diagnostics().error({*request.readings, 0, 0},
                              fmt::format("these readings are check {} of {} already, of {}",
                                          each.id, *request.history, utc_text(each.time)),
                              "nothing was saved; leave --history away to see the result again");
    files.require_good();
  }
}

void warn_of_changes(const std::vector<CheckRecord>& checks, const CheckRecord& record,
                     const std::string& history, Diagnostics& diagnostics) {
  std::set<std::string> arms;
  const CheckRecord* before = nullptr;
  for (const CheckRecord& each : checks) {
    arms.insert(each.arm);
    const bool same =
        each.arm == record.arm && each.artefact == record.artefact && each.kind == record.kind;
    if (same) before = &each;
  }
  if (!arms.empty() && !arms.contains(record.arm)) {
    diagnostics.warning({history, 0, 0},
                        fmt::format("holds checks of {} so far, and none of \"{}\"",
                                    fmt::join(arms, ", "), record.arm),
                        "is it the right file?");
  }
  if (before != nullptr && before->arm_sha256 != record.arm_sha256) {
    diagnostics.warning({history, 0, 0},
                        "the arm file is another one than at the check before: a new chart begins");
  }
}

// Without a certificate the length itself is watched.
std::vector<std::string> watched_values(const CheckRecord& check) {
  std::vector<std::string> names;
  for (const CheckedValue& each : check.values) {
    if (is_watched(each.name)) names.push_back(each.name);
  }
  const bool has_length = !check.values.empty() && check.values.back().name == "length";
  if (has_length) names.emplace_back("length");
  return names;
}

std::vector<CheckTrend> trends_of(const std::vector<CheckRecord>& checks, const CheckRecord& last,
                                  std::size_t baseline) {
  std::vector<CheckTrend> trends;
  for (const std::string& name : watched_values(last)) {
    CheckTrend trend;
    trend.name = name;
    trend.is_signed = is_signed(name);
    trend.baseline = baseline;
    for (const CheckRecord& each : checks) {
      if (!belong_together(each, last)) continue;
      for (const CheckedValue& value : each.values) {
        if (value.name != name) continue;
        trend.points.push_back({each.id, each.time, value.value_mm});
        trend.limit_mm = value.limit_mm;
      }
    }
    trends.push_back(judged(std::move(trend)));
  }
  return trends;
}

// The last check that the request can mean.
const CheckRecord& last_of(const std::vector<CheckRecord>& checks, const CheckRequest& request) {
  std::set<std::string> known;
  for (auto each = checks.rbegin(); each != checks.rend(); ++each) {
    const bool asked_for = each->arm == request.arm_name.value_or(each->arm) &&
                           each->artefact == request.artefact.value_or(each->artefact);
    if (asked_for) return *each;
    known.insert(fmt::format("\"{}\" with \"{}\"", each->arm, each->artefact));
  }
  Diagnostics diagnostics;
  diagnostics.error({*request.history, 0, 0}, "holds no such check",
                    fmt::format("it has: {}", fmt::join(known, ", ")));
  throw InputError(diagnostics);
}

void warn_of_trends(const std::vector<CheckTrend>& trends, const std::string& history,
                    Diagnostics& diagnostics) {
  for (const CheckTrend& trend : trends) {
    for (const std::string& warning : warnings_of(trend)) {
      diagnostics.warning({history, 0, 0}, warning);
    }
  }
}

void save(InputFiles& files, const CheckRequest& request, CheckSummary& summary) {
  CheckHistory history(*request.history, CheckHistory::Missing::create);
  const CheckRecord record = record_of(files, request, summary.arm, *summary.check);
  const auto before = history.checks();
  refuse_repeats(before, record, files, request);
  warn_of_changes(before, record, *request.history, files.diagnostics());
  summary.saved = history.append(record);
  summary.trends = trends_of(history.checks(), record, request.baseline);
}

void look(const CheckRequest& request, CheckSummary& summary) {
  const auto checks = CheckHistory(*request.history, CheckHistory::Missing::refuse).checks();
  const CheckRecord& last = last_of(checks, request);
  summary.arm = last.arm;
  summary.artefact = last.artefact;
  summary.trends = trends_of(checks, last, request.baseline);
}

}  // namespace

CheckSummary run_check(InputFiles& files, const CheckRequest& request,
                       const TableOptions& options) {
  CheckSummary summary;
  summary.history = request.history;
  if (request.readings) {
    const auto arm = request.arm ? files.arm(*request.arm) : std::nullopt;
    files.require_good();
    summary.arm = request.arm_name.value_or(arm ? arm->name : "");
    summary.artefact = request.artefact.value_or("");
    summary.time = request.time;
    summary.options = request.options;
    summary.temperature_C = request.temperature_c;
    summary.note = request.note;
    summary.check = measured(files, request, arm, options);
    if (request.history) save(files, request, summary);
  } else {
    look(request, summary);
  }
  if (request.history) warn_of_trends(summary.trends, *request.history, files.diagnostics());
  return summary;
}

std::string history_as_table(const std::string& history) {
  return csv_text(CheckHistory(history, CheckHistory::Missing::refuse).checks());
}

}  // namespace armcal
