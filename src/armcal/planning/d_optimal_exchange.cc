// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/planning/d_optimal_exchange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "armcal/core/parallel.h"
#include "armcal/core/random.h"
#include "armcal/numerics/linear_algebra.h"
#include "armcal/planning/chosen_rows.h"
#include "armcal/planning/reliability.h"

namespace armcal {
namespace {

// An exchange that gains less than this share of the determinant is rounding.
constexpr double kLeastGain = 1e-7;
constexpr int kMostSweeps = 50;
constexpr int kMostMends = 200;
// Candidates looked at where each look costs a whole analysis.
constexpr std::size_t kMostLooks = 60;

// The first of the largest scores. Mirrored half turns of a symmetric arm score alike but for
// rounding, which must not choose between them.
int first_of_largest(const Eigen::VectorXd& scores) {
  constexpr double kRounding = 1e-9;
  const double largest = scores.maxCoeff();
  int first = 0;
  while (scores(first) < largest - kRounding * std::abs(largest)) ++first;
  return first;
}

class Exchange {
 public:
  Exchange(const Eigen::MatrixXd& design, const Eigen::VectorXd& u, const ExchangeOptions& options)
      : design_(design * column_scales(design).cwiseInverse().asDiagonal()),
        u_(u),
        options_(options) {}

  [[nodiscard]] ChosenObservations from(int start) const {
    RandomStream random(options_.seed, static_cast<std::uint64_t>(start));
    ChosenRows choice(design_, first_rows(random));
    if (choice.is_singular()) return {};
    climb(choice);
    if (limited() && deficit(choice) > 0.0) {
      mend(choice);
      if (deficit(choice) == 0.0) polish(choice);
    }
    return judged(choice);
  }

 private:
  [[nodiscard]] bool limited() const {
    return options_.limits.least_redundancy > 0.0 || std::isfinite(largest_unnamed());
  }
  [[nodiscard]] double largest_unnamed() const {
    const double limit = options_.limits.largest_unnamed;
    return limit < 1e100 ? limit : std::numeric_limits<double>::infinity();
  }

  // Half of them by chance; the other half where the unknowns are determined worst so far.
  [[nodiscard]] std::vector<int> first_rows(RandomStream& random) const {
    std::vector<int> rows;
    std::vector<bool> taken(static_cast<std::size_t>(design_.rows()));
    // A trace of information about everything: the inverse exists from the beginning.
    constexpr double kTrace = 1e-6;
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(design_.cols(), design_.cols()) / kTrace;
    Eigen::VectorXd variance = design_.rowwise().squaredNorm() / kTrace;
    while (std::ssize(rows) < options_.observations) {
      Eigen::Index next = 0;
      if (2 * std::ssize(rows) < options_.observations) {
        next = static_cast<Eigen::Index>(random.below(taken.size()));
        if (taken[static_cast<std::size_t>(next)]) continue;
      } else {
        for (Eigen::Index row = 0; row < variance.size(); ++row) {
          if (taken[static_cast<std::size_t>(row)]) variance(row) = -1.0;
        }
        next = first_of_largest(variance);
      }
      taken[static_cast<std::size_t>(next)] = true;
      rows.push_back(static_cast<int>(next));
      const Eigen::VectorXd way = covariance * design_.row(next).transpose();
      const double divisor = 1.0 + design_.row(next).dot(way);
      variance.array() -= (design_ * way).array().square() / divisor;
      covariance.noalias() -= way * way.transpose() / divisor;
    }
    return rows;
  }

  // Each observation in turn gives its place to the one that gains most, as long as any gains.
  void climb(ChosenRows& choice) const {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool moved = false;
      for (std::size_t place = 0; place < choice.rows().size(); ++place) {
        const Eigen::VectorXd gains = choice.gains(place);
        const int best = first_of_largest(gains);
        if (gains(best) <= 1.0 + kLeastGain) continue;
        choice.exchange(place, best);
        moved = true;
      }
      choice.renew();
      if (!moved || choice.is_singular()) return;
    }
  }

  // 0 where the limits are kept, else how badly they are broken. eq. (8)
  [[nodiscard]] double deficit(const std::vector<int>& rows, const Reliability& analysis,
                               std::size_t* worst = nullptr) const {
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto place = static_cast<Eigen::Index>(i);
      double lack = 0.0;
      if (options_.limits.least_redundancy > 0.0) {
        lack = 1.0 - analysis.redundancy(place) / options_.limits.least_redundancy;
      }
      const double unnamed = u_(rows[i]) * analysis.nameable(place);
      if (std::isfinite(largest_unnamed()))
        lack = std::max(lack, 1.0 - largest_unnamed() / unnamed);
      if (lack <= 0.0) continue;
      sum += lack * lack;
      if (lack <= largest) continue;
      largest = lack;
      if (worst != nullptr) *worst = i;
    }
    return sum;
  }
  [[nodiscard]] double deficit(const ChosenRows& choice, std::size_t* worst = nullptr) const {
    return deficit(choice.rows(), reliability(choice.chosen(), choice.covariance()), worst);
  }

  // The rows with the largest scores that are not chosen yet.
  [[nodiscard]] static std::vector<int> foremost(const ChosenRows& choice,
                                                 const Eigen::VectorXd& score, std::size_t most) {
    std::vector<int> rows;
    for (Eigen::Index row = 0; row < score.size(); ++row) {
      if (!choice.is_taken(row)) rows.push_back(static_cast<int>(row));
    }
    const std::size_t kept = std::min(most, rows.size());
    std::partial_sort(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(kept), rows.end(),
                      [&](int one, int other) {
                        return score(one) != score(other) ? score(one) > score(other) : one < other;
                      });
    rows.resize(kept);
    return rows;
  }

  [[nodiscard]] double deficit_after(const ChosenRows& choice, std::size_t place, int in) const {
    std::vector<int> rows = choice.rows();
    Eigen::MatrixXd covariance = choice.covariance();
    update_inverse(covariance, design_.row(in).transpose(), 1.0);
    update_inverse(covariance, design_.row(rows[place]).transpose(), -1.0);
    rows[place] = in;
    return deficit(rows, reliability(design_(rows, Eigen::all), covariance));
  }

  // The worst observation is replaced, or another one gives way to a second look at the same thing:
  // whichever leaves least to mend.
  void mend(ChosenRows& choice) const {
    for (int round = 0; round < kMostMends; ++round) {
      if (options_.monitor.stop.stop_requested()) throw Interrupted();
      std::size_t worst = 0;
      const double before = deficit(choice, &worst);
      if (before == 0.0) return;
      double best = before;
      std::size_t best_place = 0;
      int best_row = -1;
      const auto look = [&](std::size_t place, int row) {
        const double after = deficit_after(choice, place, row);
        if (after >= best * (1.0 - kLeastGain)) return;
        best = after;
        best_place = place;
        best_row = row;
      };
      for (const int row : foremost(choice, choice.gains(worst), 4 * kMostLooks)) look(worst, row);
      const auto helpers = foremost(choice, choice.likeness(choice.rows()[worst]), kMostLooks / 3);
      for (std::size_t place = 0; place < choice.rows().size(); ++place) {
        if (place == worst) continue;
        for (const int row : helpers) look(place, row);
      }
      if (best_row < 0) return;
      choice.exchange(best_place, best_row);
      choice.renew();
      if (choice.is_singular()) return;
    }
  }

  // Climbs on within the limits.
  void polish(ChosenRows& choice) const {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool moved = false;
      for (std::size_t place = 0; place < choice.rows().size(); ++place) {
        const Eigen::VectorXd gains = choice.gains(place);
        for (const int row : foremost(choice, gains, kMostLooks / 3)) {
          if (gains(row) <= 1.0 + kLeastGain) break;
          if (deficit_after(choice, place, row) > 0.0) continue;
          choice.exchange(place, row);
          moved = true;
          break;
        }
      }
      choice.renew();
      if (!moved) return;
    }
  }

  [[nodiscard]] ChosenObservations judged(ChosenRows& choice) const {
    ChosenObservations result;
    result.rows = choice.rows();
    std::sort(result.rows.begin(), result.rows.end());
    const ChosenRows sorted(design_, result.rows);
    if (sorted.is_singular()) return {};
    const Reliability analysis = reliability(sorted.chosen(), sorted.covariance());
    result.log_determinant = sorted.log_determinant();
    result.keeps_limits = deficit(sorted) == 0.0;
    result.least_redundancy = analysis.redundancy.minCoeff();
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
      result.largest_unnamed =
          std::max(result.largest_unnamed,
                   u_(result.rows[i]) * analysis.nameable(static_cast<Eigen::Index>(i)));
    }
    return result;
  }

  Eigen::MatrixXd design_;  // columns of unit length
  const Eigen::VectorXd& u_;
  const ExchangeOptions& options_;
};

bool is_better(const ChosenObservations& one, const ChosenObservations& other) {
  if (one.rows.empty() || other.rows.empty()) return !one.rows.empty() && other.rows.empty();
  if (one.keeps_limits != other.keeps_limits) return one.keeps_limits;
  return one.log_determinant > other.log_determinant + kLeastGain;
}

}  // namespace

ChosenObservations choose_observations(const Eigen::MatrixXd& design, const Eigen::VectorXd& u,
                                       const ExchangeOptions& options) {
  if (options.observations < design.cols() || options.observations > design.rows()) {
    throw std::invalid_argument("choose_observations: between as many as unknowns and all");
  }
  const Exchange exchange(design, u, options);
  std::vector<ChosenObservations> ends(static_cast<std::size_t>(std::max(1, options.starts)));
  parallel_for(static_cast<int>(ends.size()), options.threads, [&](int start, int worker) {
    if (worker == 0) {
      options.monitor.report("exchanging half turns",
                             static_cast<double>(start) / static_cast<double>(ends.size()));
    }
    ends[static_cast<std::size_t>(start)] = exchange.from(start);
  });
  ChosenObservations best;
  for (const ChosenObservations& end : ends) {
    if (is_better(end, best)) best = end;
  }
  return best;
}

}  // namespace armcal
