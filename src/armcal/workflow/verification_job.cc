// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/verification_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/io/verification_file.h"
#include "armcal/io/verification_tables.h"
#include "armcal/workflow/verification_statistics.h"

namespace armcal {
namespace {

const char* name_of(VerificationStandard standard) {
  return standard == VerificationStandard::iso10360_12 ? "ISO 10360-12:2016" : "ASME B89.4.22-2004";
}

DecisionRule rule_of(const StatedDecision& decision) {
  constexpr std::array kKinds = {DecisionKind::iso14253_1, DecisionKind::conformance_probability,
                                 DecisionKind::simple_acceptance, DecisionKind::guard_band};
  const auto* kind = std::find_if(kKinds.begin(), kKinds.end(), [&](DecisionKind each) {
    return to_string(each) == decision.rule;
  });
  return {*kind, decision.probability, decision.guard_factor};
}

std::string title_of(const StatedTest& test, const TestResult& result) {
  const bool has_own_name = test.name != to_string(test.kind);
  return has_own_name ? fmt::format("{}, {}", result.name, test.name) : result.name;
}

struct TestOfStandard {
  const char* name;
  std::vector<StatedTestKind> kinds;  // any of which is it
};

std::vector<TestOfStandard> tests_of(VerificationStandard standard) {
  using enum StatedTestKind;
  if (standard == VerificationStandard::iso10360_12) {
    return {{"probing size and form errors", {probing}},
            {"articulated location error", {articulated_location}},
            {"length error", {length_uni, length_bi}}};
  }
  return {{"effective diameter", {effective_diameter}},
          {"single-point articulation", {single_point_articulation}},
          {"volumetric length", {volumetric_length}}};
}

std::vector<std::string> not_performed(VerificationStandard standard,
                                       const std::vector<StatedTest>& stated) {
  std::vector<std::string> names;
  for (const TestOfStandard& test : tests_of(standard)) {
    const bool is_there = std::any_of(stated.begin(), stated.end(), [&](const StatedTest& each) {
      return std::find(test.kinds.begin(), test.kinds.end(), each.kind) != test.kinds.end();
    });
    if (!is_there) names.emplace_back(test.name);
  }
  return names;
}

class VerificationJob {
 public:
  VerificationJob(InputFiles& files, const std::string& path, const VerificationWishes& wishes)
      : files_(files), path_(path), wishes_(wishes) {}

  Verification run() {
    read_file();
    read_arms();
    read_artefacts();
    files_.require_good();
    for (const StatedTest& test : file_.tests) {
      if (is_asked_for(test)) run_test(test);
    }
    files_.require_good();
    require_values();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_asked_for(const StatedTest& test) const {
    return is_of_iso(test.kind) == (wishes_.standard == VerificationStandard::iso10360_12);
  }

  void read_file() {
    const auto text = files_.text(path_, kLargestConfiguration_bytes);
    auto file = text ? read_verification_file(*text, files_.diagnostics()) : std::nullopt;
    files_.require_good();
    file_ = std::move(*file);
    if (wishes_.arm_file) file_.arm_file = *wishes_.arm_file;
    if (wishes_.as_left_file) file_.as_left_file = *wishes_.as_left_file;
    const bool has_tests = std::any_of(file_.tests.begin(), file_.tests.end(),
                                       [&](const StatedTest& test) { return is_asked_for(test); });
    if (!has_tests) {
      files_.diagnostics().error(
          {path_, 0, 0}, fmt::format("has no test of {}", name_of(wishes_.standard)),
          wishes_.standard == VerificationStandard::iso10360_12
              ? "its kinds are probing, articulated_location, length_uni, length_bi"
              : "its kinds are effective_diameter, single_point_articulation, volumetric_length; "
                "and half_range");
    }
    result_.name = file_.name;
    result_.standard = name_of(wishes_.standard);
    result_.rule = rule_of(file_.decision);
    result_.coverage_factor = file_.decision.coverage_factor;
    result_.environment = file_.environment;
    result_.not_performed = not_performed(wishes_.standard, file_.tests);
  }

  void read_arms() {
    if (!file_.as_left_file.empty() && file_.arm_file.empty()) {
      files_.diagnostics().error({path_, 0, 0}, "names an arm as left but none as found",
                                 "give the arm that the readings were taken with: arm = \"..\", "
                                 "or --arm ARM");
    }
    if (!file_.arm_file.empty()) as_found_ = files_.arm(file_.arm_file);
    if (!file_.as_left_file.empty()) as_left_ = files_.arm(file_.as_left_file);
    if (as_found_ && as_left_ && as_found_->joint_count() != as_left_->joint_count()) {
      files_.diagnostics().error(
          {file_.as_left_file, 0, 0},
          fmt::format("has {} joints, {} has {}", as_left_->joint_count(), file_.arm_file,
                      as_found_->joint_count()),
          "as found and as left are the same arm, before and after its adjustment");
    }
    result_.arm_file = file_.arm_file;
    result_.as_left_file = file_.as_left_file;
    result_.reach_mm = file_.reach_mm;
    if (!result_.reach_mm && as_found_) result_.reach_mm = reach_mm(*as_found_);
  }

  void read_artefacts() {
    for (StatedArtefact& artefact : file_.artefacts) {
      if (artefact.file.empty()) continue;
      const auto table = files_.table(artefact.file, {});
      if (!table) continue;
      if (auto lengths = certified_lengths(*table, files_.diagnostics())) {
        artefact.lengths = std::move(*lengths);
      }
    }
    for (const StatedArtefact& artefact : file_.artefacts) {
      const bool is_used =
          std::any_of(file_.tests.begin(), file_.tests.end(), [&](const StatedTest& test) {
            return is_asked_for(test) && test.artefact == artefact.name;
          });
      if (is_used) result_.artefacts.push_back(artefact);
    }
  }

  // Tests may share a table: it is read, and listed among the inputs, once.
  const CsvTable* table_of(const StatedTest& test) {
    const auto key = std::pair(test.file, test.table.map);
    const auto at = tables_.find(key);
    if (at != tables_.end()) return at->second ? &*at->second : nullptr;
    const auto& table = tables_.emplace(key, files_.table(test.file, test.table)).first->second;
    return table ? &*table : nullptr;
  }

  void run_test(StatedTest test) {
    test.table.keep_duplicates |= wishes_.keep_duplicates;
    test.table.keep_zero_points |= wishes_.keep_zero_points;
    const CsvTable* table = table_of(test);
    if (table == nullptr) return;
    const StatedArtefact* artefact = file_.artefact(test.artefact);
    const auto rows = verification_rows(
        *table, test, artefact, as_found_ ? as_found_->joint_count() : 0, files_.diagnostics());
    if (!rows) return;
    const PreparedTest prepared{
        test,
        artefact,
        {file_.environment.temperature_C, file_.environment.u_temperature_K},
        result_.reach_mm};
    const auto as_found = measured(prepared, *rows, as_found_, as_left_ ? "as found, " : "");
    std::vector<TestResult> as_left;
    if (as_left_ && rows->has_angles()) {
      as_left = measured(prepared, *rows, as_left_, "as left, ");
    } else if (as_left_) {
      files_.diagnostics().warning(
          {rows->file, 0, 0},
          fmt::format("{} is judged as found only: its table holds no joint angles", test.name),
          "record joint angles, which can be put through the arm as left");
    }
    judge_results(prepared, as_found, as_left);
  }

  // @param whose  begins what is said of readings that cannot be those of the artefact
  std::vector<TestResult> measured(const PreparedTest& test, const VerificationRows& rows,
                                   const std::optional<ArmModel>& arm, const char* whose) {
    const std::size_t errors_before = files_.diagnostics().error_count();
    const auto tips = rows.has_angles() ? tips_in_base(*arm, rows.encoder_rad) : rows.points_mm;
    const Eigen::Vector3d first_axis_mm =
        arm ? b89_4_22::reach_of(*arm).first_axis_origin_mm : file_.origin_mm;
    auto results = statistics_of(test, {rows, tips}, first_axis_mm, files_.diagnostics());
    if (files_.diagnostics().error_count() > errors_before) return {};
    complain(test.stated, results, whose);
    return results;
  }

  // Statistics of one test share their readings, and so their faults: each is told once.
  void complain(const StatedTest& test, const std::vector<TestResult>& results, const char* whose) {
    for (const TestResult& result : results) {
      for (const std::string& problem : result.problems) {
        tell(test, whose + problem,
             "is it the table of this test, in mm, and the right artefact and probe?");
      }
      if (wishes_.incomplete) continue;
      for (const std::string& missing : result.missing) {
        tell(test, missing,
             "measure what is missing, or give --incomplete for values without the standard's "
             "name");
      }
    }
  }

  void tell(const StatedTest& test, const std::string& what, const std::string& remedy) {
    if (!told_.emplace(test.where.line, what).second) return;
    files_.diagnostics().error(test.where, fmt::format("{}: {}", test.name, what), remedy);
  }

  void judge_results(const PreparedTest& test, const std::vector<TestResult>& as_found,
                     const std::vector<TestResult>& as_left) {
    if (files_.diagnostics().has_errors()) return;
    for (std::size_t i = 0; i < as_found.size(); ++i) {
      VerifiedStatistic statistic;
      statistic.test = test.stated.name;
      statistic.title = title_of(test.stated, as_found[i]);
      statistic.budgets = budgets_of(test, i);
      const auto limit = limit_of(test.stated, i);
      if (limit) statistic.limit = limit->text();
      statistic.mpe = limit;
      statistic.artefact = test.stated.artefact;
      const auto judged = [&](const TestResult& result) {
        return judge(result, limit,
                     uncertainties_of(statistic.budgets, test, result, result_.coverage_factor),
                     result_.rule);
      };
      statistic.as_found = judged(as_found[i]);
      if (i < as_left.size()) statistic.as_left = judged(as_left[i]);
      result_.statistics.push_back(std::move(statistic));
    }
  }

  void require_values() const {
    const auto& statistics = result_.statistics;
    const bool any = std::any_of(statistics.begin(), statistics.end(), [](const auto& each) {
      return each.judged().result.value_mm.has_value();
    });
    if (!any) {
      throw NumericalError(fmt::format("{}: the readings are too few to compute anything", path_));
    }
  }

  InputFiles& files_;
  const std::string& path_;
  const VerificationWishes& wishes_;
  VerificationFile file_;
  std::optional<ArmModel> as_found_;
  std::optional<ArmModel> as_left_;
  std::map<std::pair<std::string, ColumnMap>, std::optional<CsvTable>> tables_;
  std::set<std::pair<int, std::string>> told_;
  Verification result_;
};

}  // namespace

Verification run_verification(InputFiles& files, const std::string& path,
                              const VerificationWishes& wishes) {
  return VerificationJob(files, path, wishes).run();
}

}  // namespace armcal
