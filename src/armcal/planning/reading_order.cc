// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/reading_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace armcal {
namespace {

// A joint more is worse than any way of the joints that move.
constexpr double kPerRadian = 1e-4;
constexpr int kMostRounds = 60;

// What it costs to read in this order when nothing moves that need not.
class Cost {
 public:
  explicit Cost(std::span<const HalfTurn> turns) : turns_(turns) {}

  [[nodiscard]] int joints() const { return joints_; }

  double operator()(std::span<const int> order) {
    if (order.empty()) return 0.0;
    Eigen::VectorXd& at = at_;
    at = turns_[static_cast<std::size_t>(order.front())].posture_rad;
    joints_ = 0;
    double way = 0.0;
    for (const int place : order) {
      const HalfTurn& turn = turns_[static_cast<std::size_t>(place)];
      for (Eigen::Index j = turn.joint; j < at.size(); ++j) {
        const double step = std::abs(turn.posture_rad(j) - at(j));
        if (step <= kSameAngle_rad) continue;
        ++joints_;
        way += step;
        at(j) = turn.posture_rad(j);
      }
      double& turned = at(turn.joint - 1);
      turned += turned > kSameAngle_rad ? -std::numbers::pi : std::numbers::pi;
    }
    return joints_ + kPerRadian * way;
  }

 private:
  std::span<const HalfTurn> turns_;
  Eigen::VectorXd at_;
  int joints_ = 0;
};

// By joint, then by the angles behind it, the last one changing fastest.
std::vector<int> first_order(std::span<const HalfTurn> turns) {
  std::vector<int> order(turns.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int one, int other) {
    const HalfTurn& a = turns[static_cast<std::size_t>(one)];
    const HalfTurn& b = turns[static_cast<std::size_t>(other)];
    if (a.joint != b.joint) return a.joint < b.joint;
    for (Eigen::Index j = a.joint; j < a.posture_rad.size(); ++j) {
      const double step = a.posture_rad(j) - b.posture_rad(j);
      if (std::abs(step) > kSameAngle_rad) return step < 0.0;
    }
    return false;
  });
  return order;
}

}  // namespace

std::vector<int> reading_order(std::span<const HalfTurn> turns, const Monitor& monitor) {
  Cost cost(turns);
  std::vector<int> order = first_order(turns);
  double best = cost(order);
  std::vector<int> tried = order;
  const auto keep_if_better = [&] {
    const double now = cost(tried);
    const bool better = now < best - 1e-9;
    if (better) {
      best = now;
      order = tried;
    } else {
      tried = order;
    }
    return better;
  };
  const auto n = static_cast<std::ptrdiff_t>(order.size());
  for (int sweep = 0; sweep < kMostRounds; ++sweep) {
    monitor.report("ordering the readings", static_cast<double>(sweep) / kMostRounds);
    bool moved = false;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      for (std::ptrdiff_t j = i + 1; j < n; ++j) {
        std::reverse(tried.begin() + i, tried.begin() + j + 1);
        moved = keep_if_better() || moved;
        std::rotate(tried.begin() + i, tried.begin() + i + 1, tried.begin() + j + 1);
        moved = keep_if_better() || moved;
        std::rotate(tried.begin() + i, tried.begin() + j, tried.begin() + j + 1);
        moved = keep_if_better() || moved;
      }
    }
    if (!moved) break;
  }
  return order;
}

int joints_to_set(std::span<const HalfTurn> turns, std::span<const int> order) {
  Cost cost(turns);
  static_cast<void>(cost(order));
  return cost.joints();
}

}  // namespace armcal
