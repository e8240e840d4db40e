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
#include "armcal/planning/reliability.h"

namespace armcal {
namespace {

// An exchange that gains less than this share of the determinant is rounding.
constexpr double kLeastGain = 1e-7;
constexpr int kMostSweeps = 50;
constexpr int kMostMends = 200;
// Candidates looked at where each look costs a whole analysis.
constexpr std::size_t kMostLooks = 60;

// The inverse of M + sign * row row^T from that of M; returns the factor by which the determinant
// grows.
double add_to_information(Eigen::MatrixXd& inverse, const Eigen::VectorXd& row, double sign) {
  const Eigen::VectorXd way = inverse * row;
  const double factor = 1.0 + sign * row.dot(way);
  inverse.noalias() -= (sign / factor) * way * way.transpose();
  return factor;
}

// A choice of rows with the inverse of its information matrix, kept up by rank-one updates.
class Choice {
 public:
  Choice(const Eigen::MatrixXd& design, std::vector<int> rows)
      : design_(&design), rows_(std::move(rows)), taken_(static_cast<std::size_t>(design.rows())) {
    for (const int row : rows_) taken_[static_cast<std::size_t>(row)] = true;
    renew();
  }

  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }
  [[nodiscard]] bool is_taken(Eigen::Index row) const {
    return taken_[static_cast<std::size_t>(row)];
  }
  [[nodiscard]] bool is_singular() const { return singular_; }
  [[nodiscard]] const Eigen::MatrixXd& covariance() const { return covariance_; }
  [[nodiscard]] Eigen::MatrixXd chosen() const { return (*design_)(rows_, Eigen::all); }
  [[nodiscard]] double log_determinant() const { return log_determinant_; }

  /// By which factor the determinant grows when place `place` is given to each row. eq. (7)
  [[nodiscard]] Eigen::VectorXd gains(std::size_t place) const {
    const int out = rows_[place];
    const Eigen::VectorXd across = *design_ * (covariance_ * design_->row(out).transpose());
    Eigen::VectorXd gain =
        ((1.0 + variance_.array()) * (1.0 - variance_(out)) + across.array().square()).matrix();
    for (Eigen::Index row = 0; row < gain.size(); ++row) {
      if (is_taken(row)) gain(row) = 0.0;
    }
    return gain;
  }

  void exchange(std::size_t place, int in) {
    const int out = rows_[place];
    add(in, 1.0);
    add(out, -1.0);
    taken_[static_cast<std::size_t>(out)] = false;
    taken_[static_cast<std::size_t>(in)] = true;
    rows_[place] = in;
  }

  /// Everything from the rows themselves: rank-one updates collect rounding.
  void renew() {
    const auto factor = inverse_factor(chosen());
    singular_ = !factor.has_value();
    if (singular_) return;
    covariance_ = *factor * factor->transpose();
    variance_ = (*design_ * *factor).rowwise().squaredNorm();
    Eigen::MatrixXd triangle = chosen();
    triangularise(triangle);
    log_determinant_ = 2.0 * triangle.diagonal().cwiseAbs().array().log().sum();
  }

  /// Share of the two rows' predictions that is common: which rows look after which.
  [[nodiscard]] Eigen::VectorXd likeness(int row) const {
    const Eigen::VectorXd across = *design_ * (covariance_ * design_->row(row).transpose());
    return (across.array().square() / (1.0 + variance_.array())).matrix();
  }

 private:
  void add(int row, double sign) {
    const Eigen::VectorXd across = *design_ * (covariance_ * design_->row(row).transpose());
    const double factor = add_to_information(covariance_, design_->row(row).transpose(), sign);
    variance_.array() -= sign * across.array().square() / factor;
  }

  const Eigen::MatrixXd* design_;
  std::vector<int> rows_;
  std::vector<bool> taken_;
  Eigen::MatrixXd covariance_;
  Eigen::VectorXd variance_;  // of the prediction of every row
  double log_determinant_ = 0.0;
  bool singular_ = false;
};

class Exchange {
 public:
  Exchange(const Eigen::MatrixXd& design, const Eigen::VectorXd& u, const ExchangeOptions& options)
      : design_(design * column_scales(design).cwiseInverse().asDiagonal()),
        u_(u),
        options_(options) {}

  [[nodiscard]] ChosenObservations from(int start) const {
    RandomStream random(options_.seed, static_cast<std::uint64_t>(start));
    Choice choice(design_, first_rows(random));
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
        variance.maxCoeff(&next);
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
  void climb(Choice& choice) const {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      bool moved = false;
      for (std::size_t place = 0; place < choice.rows().size(); ++place) {
        Eigen::Index best = 0;
        if (choice.gains(place).maxCoeff(&best) <= 1.0 + kLeastGain) continue;
        choice.exchange(place, static_cast<int>(best));
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
  [[nodiscard]] double deficit(const Choice& choice, std::size_t* worst = nullptr) const {
    return deficit(choice.rows(), reliability(choice.chosen(), choice.covariance()), worst);
  }

  // The rows with the largest scores that are not chosen yet.
  [[nodiscard]] static std::vector<int> foremost(const Choice& choice, const Eigen::VectorXd& score,
                                                 std::size_t most) {
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

  [[nodiscard]] double deficit_after(const Choice& choice, std::size_t place, int in) const {
    std::vector<int> rows = choice.rows();
    Eigen::MatrixXd covariance = choice.covariance();
    add_to_information(covariance, design_.row(in).transpose(), 1.0);
    add_to_information(covariance, design_.row(rows[place]).transpose(), -1.0);
    rows[place] = in;
    return deficit(rows, reliability(design_(rows, Eigen::all), covariance));
  }

  // The worst observation is replaced, or another one gives way to a second look at the same thing:
  // whichever leaves least to mend.
  void mend(Choice& choice) const {
    for (int round = 0; round < kMostMends; ++round) {
      if (options_.monitor.stop.stop_requested()) throw Interrupted();
      std::size_t worst = 0;
      const double before = deficit(choice, &worst);
      if (before == 0.0) return;
      double best = before * (1.0 - kLeastGain);
      std::size_t best_place = 0;
      int best_row = -1;
      const auto look = [&](std::size_t place, int row) {
        const double after = deficit_after(choice, place, row);
        if (after >= best) return;
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
  void polish(Choice& choice) const {
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

  [[nodiscard]] ChosenObservations judged(Choice& choice) const {
    ChosenObservations result;
    result.rows = choice.rows();
    std::sort(result.rows.begin(), result.rows.end());
    const Choice sorted(design_, result.rows);
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
  return one.log_determinant > other.log_determinant;
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
