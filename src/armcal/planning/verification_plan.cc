// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "armcal/planning/verification/articulated_location_plan.h"
#include "armcal/planning/verification/effective_diameter_plan.h"
#include "armcal/planning/verification/joint_coverage.h"
#include "armcal/planning/verification/length_plan.h"
#include "armcal/planning/verification/probing_plan.h"
#include "armcal/planning/verification/single_point_plan.h"
#include "armcal/planning/verification/touch_plan.h"
#include "armcal/planning/verification/volumetric_plan.h"

namespace armcal {
namespace {

constexpr const char* kHelp =
    "\n  help: state the arm's own --reach, choose other --lengths or --bars, make more room, or "
    "try "
    "another --seed";

using Planner = PlannedTest (*)(const PlanningCircumstances&);

void require_positive(const char* what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("{} of {} mm: must be larger than 0", what, value));
}

void check(const VerificationPlanWishes& wishes) {
  require_positive("a sphere with a diameter", wishes.sphere_diameter_mm);
  require_positive("a tip with a diameter", wishes.tip_diameter_mm);
  for (const double length : wishes.lengths_mm) require_positive("a length", length);
  for (const double bar : wishes.bars_mm) require_positive("a bar", bar);
  if (std::adjacent_find(wishes.lengths_mm.begin(), wishes.lengths_mm.end(),
                         std::greater_equal<>()) != wishes.lengths_mm.end()) {
    throw std::invalid_argument("lengths must rise, and none may be there twice");
  }
}

VerificationPlanWishes with_defaults(VerificationPlanWishes wishes, double reach_mm) {
  if (wishes.lengths_mm.empty()) wishes.lengths_mm = usual_lengths(reach_mm);
  const auto usual = usual_bars(reach_mm);
  for (std::size_t i = 0; i < usual.size(); ++i) {
    if (wishes.bars_mm[i] == 0.0) wishes.bars_mm[i] = usual[i];
  }
  return wishes;
}

std::vector<Planner> planners(const VerificationPlanWishes& wishes) {
  std::vector<Planner> list;
  if (wishes.iso10360_12) list = {plan_probing, plan_articulated_location, plan_length_uni};
  if (wishes.b89_4_22) {
    list.insert(list.end(),
                {plan_effective_diameter, plan_single_point_articulation, plan_volumetric_length});
  }
  return list;
}

Eigen::VectorXd coverage_of(const ArmModel& arm, const std::vector<PlannedTest>& tests) {
  std::vector<Eigen::VectorXd> postures;
  for (const PlannedTest& test : tests) {
    for (const PlannedTouch& row : test.touches) postures.push_back(row.encoder_rad);
  }
  return joint_coverage(arm, postures);
}

}  // namespace

VerificationPlan plan_verification(const ArmModel& arm, const VerificationPlanWishes& wishes,
                                   const Monitor& monitor) {
  VerificationPlan plan;
  plan.arm = arm;
  plan.reach_mm = wishes.reach_mm.value_or(reach_mm(arm));
  require_positive("a reach", plan.reach_mm);
  plan.wishes = with_defaults(wishes, plan.reach_mm);
  check(plan.wishes);
  const TouchSearch search(arm, plan.wishes.room);
  const PlanningCircumstances with{search, plan.wishes, plan.reach_mm};
  const auto list = planners(plan.wishes);
  std::string problems;
  for (std::size_t i = 0; i < list.size(); ++i) {
    monitor.report("planning tests", static_cast<double>(i) / static_cast<double>(list.size()));
    try {
      plan.tests.push_back(list[i](with));
      plan.tests.back().joint_coverage = coverage_of(arm, {plan.tests.back()});
    } catch (const ImpossiblePlan& impossible) {
      problems += fmt::format("{}{}", problems.empty() ? "" : "\n", impossible.what());
    }
  }
  if (!problems.empty()) throw ImpossiblePlan(problems + kHelp);
  plan.joint_coverage = coverage_of(arm, plan.tests);
  return plan;
}

}  // namespace armcal
