// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/symmetric_point/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armcal/arm/parameter_table.h"
#include "armcal/numerics/median.h"
#include "armcal/symmetric_point/reading_model.h"

namespace armcal {
namespace {

// Lengths of an arm that was computed elsewhere are good to their last printed digit.
constexpr double kComparedUncertainty_mm = 0.0005;

std::vector<int> asked_unknowns(const SymmetricPointProcedure& procedure,
                                const ParameterTable& table) {
  std::set<int> chosen;
  std::vector<std::string> patterns = procedure.unknowns;
  if (patterns.empty()) {
    for (const SymmetricReading& reading : procedure.readings) {
      if (!reading.solves.empty()) patterns.push_back(reading.solves);
    }
  }
  if (patterns.empty()) patterns.emplace_back("*");
  for (const std::string& pattern : patterns) {
    for (const int index : table.matching(pattern)) chosen.insert(index);
  }
  for (const std::string& pattern : procedure.hold) {
    for (const int index : table.matching(pattern)) chosen.erase(index);
  }
  return {chosen.begin(), chosen.end()};
}

std::vector<Claim> claims_of(const ArmModel& arm) {
  const ParameterTable table(arm);
  std::vector<Claim> claims;
  for (const Parameter& parameter : table.parameters()) {
    if (parameter.unit == ParameterUnit::mm && parameter.nominal != 0.0) {
      claims.push_back({parameter.name, parameter.nominal, kComparedUncertainty_mm, {}});
    }
  }
  return claims;
}

Eigen::VectorXd predictions(const ArmModel& arm, const std::vector<SymmetricReading>& readings) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) = predict(arm, readings[i]).value;
  }
  return values;
}

bool reduce_all(const std::vector<SymmetricReading>& raw, SymmetricPointAnalysis& analysis,
                Diagnostics& diagnostics) {
  bool good = true;
  for (const SymmetricReading& reading : raw) {
    const auto reduced = reduce(reading, analysis.nominal, diagnostics);
    good = good && reduced.has_value();
    if (!reduced) continue;
    analysis.readings.push_back(reduced->reading);
    if (!reading.reduced) analysis.reductions.push_back(reduced->reduction);
  }
  return good;
}

// The same machine took them all: a reading that repeats so much worse than the others of its kind
// hides a blunder, also where its own repeats are too few to tell which. Zero searches are left
// out: their uncertainty is that of a slope over a bend, which differs from joint to joint.
void warn_of_wide_scatter(const SymmetricPointAnalysis& analysis, Diagnostics& diagnostics) {
  constexpr double kWide = 10.0;
  constexpr double kNoticeable_mm = 0.01;
  struct Scatter {
    const SymmetricReading* reading;
    double u_mm;
  };
  std::vector<Scatter> all;
  for (const Reduction& reduction : analysis.reductions) {
    for (const SymmetricReading& reading : analysis.readings) {
      if (reading.name != reduction.reading || reading.is_angle()) continue;
      if (reduction.u_type_a > 0.0) all.push_back({&reading, reduction.u_type_a});
    }
  }
  for (const Scatter& one : all) {
    std::vector<double> others;
    for (const Scatter& other : all) {
      const bool same_kind = other.reading->kind == one.reading->kind;
      if (same_kind && other.reading != one.reading) others.push_back(other.u_mm);
    }
    if (others.size() < 2 || one.u_mm < kNoticeable_mm) continue;
    const double usual = median(others);
    if (one.u_mm <= kWide * usual) continue;
    diagnostics.warning(
        {one.reading->raw->file, 0, 0},
        fmt::format("reading \"{}\" scatters far more than the others of its kind: standard "
                    "uncertainty {:.4f} mm from its repeats, usually {:.4f} mm",
                    one.reading->name, one.u_mm, usual),
        "look for a blunder among its points");
  }
}

// Of the chain where it is complete, else of the adjustment; none where neither exists.
void add_leakage(SymmetricPointAnalysis& analysis) {
  std::optional<Leakage> leakage;
  if (analysis.chain && analysis.chain->complete) {
    leakage = leakage_of_chain(analysis.chain->arm, analysis.readings);
    analysis.leakage_of_chain = leakage.has_value();
  }
  if (!leakage && analysis.adjustment.ok()) {
    leakage = leakage_of_adjustment(analysis.adjustment.arm, analysis.readings,
                                    analysis.adjustment.unknowns);
  }
  if (leakage) analysis.leakage = std::move(*leakage);
}

}  // namespace

bool SymmetricPointAnalysis::is_consistent() const {
  return adjustment.ok() && !adjustment.has_flagged() &&
         std::all_of(claims.begin(), claims.end(),
                     [](const ClaimCheck& claim) { return claim.agrees; });
}

std::optional<SymmetricPointAnalysis> analyse_symmetric_points(
    const SymmetricPointProcedure& procedure, const ArmModel& nominal,
    const std::optional<ArmModel>& compared, Diagnostics& diagnostics) {
  SymmetricPointAnalysis analysis;
  analysis.nominal = nominal;
  Diagnostics first;  // reducing twice, each warning is told once
  const bool again = !procedure.unknown_signs.empty();
  const bool reduced = reduce_all(procedure.readings, analysis, first);
  if (!reduced || !again) diagnostics.append(first);
  if (!reduced) return std::nullopt;
  analysis.signs = search_signs(nominal, analysis.readings, procedure.unknown_signs);
  analysis.nominal = analysis.signs.front().arm;
  if (again) {
    // A zero search is reduced with the shape of the nominal arm: once more, with its signs
    // settled.
    analysis.readings.clear();
    analysis.reductions.clear();
    if (!reduce_all(procedure.readings, analysis, diagnostics)) return std::nullopt;
  }
  warn_of_wide_scatter(analysis, diagnostics);
  analysis.predicted_by_nominal = predictions(analysis.nominal, analysis.readings);

  const ParameterTable table(analysis.nominal);
  AdjustmentOptions options;
  options.unknowns = asked_unknowns(procedure, table);
  options.significance = procedure.significance;
  options.power = procedure.power;
  analysis.adjustment = adjust(analysis.nominal, analysis.readings, options);

  const bool has_chain =
      std::any_of(analysis.readings.begin(), analysis.readings.end(),
                  [](const SymmetricReading& reading) { return !reading.solves.empty(); });
  if (has_chain) analysis.chain = solve_chain(analysis.nominal, analysis.readings);
  add_leakage(analysis);
  const std::vector<Claim> claims = compared ? claims_of(*compared) : procedure.claims;
  if (analysis.adjustment.ok()) {
    analysis.claims =
        check_claims(analysis.nominal, analysis.readings, options, analysis.adjustment, claims);
  }
  if (compared) {
    analysis.compared = compared;
    analysis.predicted_by_compared = predictions(*compared, analysis.readings);
  }
  return analysis;
}

}  // namespace armcal
