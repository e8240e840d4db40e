// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armcal/identification/residuals/whitening.h"
#include "armcal/identification/unknowns.h"
#include "armcal/numerics/least_squares.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

/// The arm at one point of the iteration, shared by all residuals.
struct ArmAt {
  ArmModel arm;
  TipRows tips;  ///< with the columns of Unknowns
};

/// Where observations are in space: base frame, one column each.
struct ObservedPlaces {
  /// The measured point by the arm (poses: the origin of the target; reversal: before the turn); no
  /// columns for a kind without one.
  Eigen::Matrix3Xd point_mm;
  /// Kinds that compare one number: the unit vector along which moving the point enlarges what the
  /// arm predicts. No columns for kinds that compare x, y and z.
  Eigen::Matrix3Xd direction;
};

/// The observations of one group that share their unknowns: one set-up, one fixed point, one
/// placement. A kind of reference is one class derived from this, in a file of its own, and a line
/// in registry.cc.
///
/// Columns of its rows: the arm's free parameters (where it depends on the arm), then its nuisances
/// in their order. Rows are in mm until they are whitened.
class Residual {
 public:
  /// @param rows  of the group, in file order
  Residual(const ObservationGroup& group, std::vector<int> rows)
      : group_(&group), rows_(std::move(rows)) {}
  virtual ~Residual() = default;
  Residual(const Residual&) = delete;
  Residual& operator=(const Residual&) = delete;

  [[nodiscard]] const ObservationGroup& group() const { return *group_; }
  /// Row of the group that observation `i` came from.
  [[nodiscard]] int row(Eigen::Index i) const { return rows_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(rows_.size()); }
  [[nodiscard]] const std::vector<int>& nuisances() const { return nuisances_; }

  [[nodiscard]] virtual Eigen::Index rows_per_observation() const { return 3; }
  [[nodiscard]] virtual bool depends_on_arm() const { return true; }
  /// Do these observations know how long a millimetre is? A fixed point does not: an arm that is
  /// longer by one in a thousand fits it as well.
  [[nodiscard]] virtual bool knows_scale() const { return true; }

  /// Gives its nuisances their start values on the nominal arm, those that have none yet.
  /// @return in words why it cannot, where the observations are too poor
  [[nodiscard]] virtual std::optional<std::string> start(const ArmAt& nominal, Unknowns& unknowns,
                                                         Eigen::VectorXd& x) const = 0;

  /// Fills observations first .. first + count - 1; `first` is a multiple of kLanes.
  virtual void fill(const ArmAt& at, const Unknowns& unknowns, const Eigen::VectorXd& x,
                    Eigen::Index first, Eigen::Index count, const BlockRows& rows) const = 0;

  /// By default nowhere: lengths are between points, and of no posture.
  [[nodiscard]] virtual ObservedPlaces places(const ArmAt& at, const Unknowns& unknowns,
                                              const Eigen::VectorXd& x) const;

  /// How the rows, all observations one below the other, move with the encoder readings (mm/rad).
  /// Columns: the readings of one observation, those after a turn behind those before it; none
  /// where the kind has no encoders.
  [[nodiscard]] virtual Eigen::MatrixXd J_residual_encoders(const ArmModel& arm,
                                                            const Unknowns& unknowns,
                                                            const Eigen::VectorXd& x) const = 0;

  /// Takes the weights of its observations where they move with the encoders: constants of every
  /// solve that follows. Needed before whiten() where encoders are uncertain.
  void weigh(const ArmModel& arm, const Unknowns& unknowns, const Eigen::VectorXd& x);
  /// Divides filled rows of observations first .. by their uncertainty.
  void whiten(Eigen::Index first, Eigen::Index count, const BlockRows& rows) const;
  /// Sum of the variances of its rows as they are stated, mm^2: that of the reference and of the
  /// encoders.
  [[nodiscard]] double variance(Eigen::Index i) const;
  /// By how much whitening enlarges an error of a row at most, 1/mm.
  [[nodiscard]] double largest_weight(Eigen::Index i) const;

 protected:
  /// Encoder readings of its rows.
  [[nodiscard]] Eigen::MatrixXd encoders(const Eigen::MatrixXd& of_group) const;
  /// All its tips on an arm.
  [[nodiscard]] static Eigen::Matrix3Xd all_tips(const TipRows& tips, const PosturePacks& postures);

  std::vector<int> nuisances_;

 private:
  const ObservationGroup* group_;
  std::vector<int> rows_;
  std::optional<Whitening> whitening_;  // where rows are not simply divided by u_mm
};

/// Most observations that are filled at once.
inline constexpr Eigen::Index kObservationsPerBlock = 64;

/// First values of what they bring along, lengths last: they start from points that others give.
/// @return what stands in the way, one after the other; empty: nothing
[[nodiscard]] std::string start_all(const std::vector<std::unique_ptr<Residual>>& residuals,
                                    const ArmAt& at, Unknowns& unknowns, Eigen::VectorXd& x);

/// Weighs all of them. theory/identification.md eq. (18)
void weigh_all(const std::vector<std::unique_ptr<Residual>>& residuals, const Unknowns& unknowns,
               const Eigen::VectorXd& x);

/// Cuts a group into residuals, registering what they bring along as unknown. Rows of the other set
/// (fit or check) are left out. The group must outlive them.
[[nodiscard]] std::vector<std::unique_ptr<Residual>> residuals_of(const ObservationGroup& group,
                                                                  bool check_rows,
                                                                  Unknowns& unknowns);

}  // namespace armcal
