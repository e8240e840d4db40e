// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/verification/touch_plan.h"

#include <fmt/format.h>

namespace armcal {
namespace {

constexpr std::size_t kCandidates = 4;
constexpr int kTouchStarts = 60;
// A place was chosen because two of 40 starts led there.
constexpr int kLastStarts = 1000;

}  // namespace

void add_touch(const TouchSearch& search, PlannedTest& test, PlannedTouch row,
               RandomStream& random) {
  auto candidates = search.postures(row.touch, kCandidates, kTouchStarts, random);
  if (candidates.empty()) candidates = search.postures(row.touch, 1, kLastStarts, random);
  if (candidates.empty()) {
    const Eigen::Vector3d& at = row.touch.tip_mm;
    throw ImpossiblePlan(
        fmt::format("{}: the point at ({:.1f}, {:.1f}, {:.1f}) mm is hard to "
                    "reach; try another --seed",
                    test.title, at.x(), at.y(), at.z()));
  }
  std::vector<Eigen::VectorXd> before;
  for (const PlannedTouch& each : test.touches) before.push_back(each.encoder_rad);
  row.encoder_rad = farthest_from(before, candidates);
  test.touches.push_back(std::move(row));
}

std::string distance_text(const PlanningCircumstances& with, const Eigen::Vector3d& point_mm) {
  const double share = with.share_of_reach(point_mm);
  return fmt::format("{:.0f} mm ({:.0f} % of the reach)", share * with.reach_mm, 100.0 * share);
}

}  // namespace armcal
