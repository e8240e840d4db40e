// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "armcal/arm/arm_model.h"
#include "armcal/arm/parameter_table.h"
#include "armcal/core/progress.h"
#include "armcal/numerics/least_squares.h"
#include "armcal/observations/observation_group.h"

namespace armcal {

struct CalibrationOptions {
  std::vector<std::string> hold;  ///< names or globs of parameters that stay nominal
  int harmonics = 0;              ///< encoder harmonics per joint, beside those that the arm has
  /// Standard uncertainties of the nominal values; a parameter of a kind without one has no prior.
  std::optional<double> prior_length_mm, prior_zero_rad, prior_twist_rad, prior_harmonic_rad;
  std::map<std::string, double> prior_of;  ///< by parameter name, mm or rad; goes before the above
  RobustLoss loss = RobustLoss::none;
  /// Go on where fixed points alone leave the size of the arm open: the longest length is held
  /// then.
  bool allow_rank_deficient = false;
  /// A parameter that the readings determine no better than this is as good as unseen and is held.
  double largest_useful_u_mm = 5.0;
  double largest_useful_u_rad = 0.05;
  int threads = 1;
  Monitor monitor;
};

enum class CalibrationStatus {
  converged,
  no_readings,
  cannot_start,   ///< a frame, sphere or plane cannot be placed; see `detail`
  scale_unknown,  ///< no reading knows how long a millimetre is
  nothing_determined,
  no_convergence,  ///< see `termination`
};
[[nodiscard]] std::string_view explain(CalibrationStatus status);

struct CalibratedParameter {
  std::string name;
  ParameterUnit unit = ParameterUnit::mm;
  double nominal = 0.0;
  double value = 0.0;
  double u = 0.0;  ///< standard uncertainty, widened by sigma0 where that exceeds 1; 0 when held
  ParameterStatus status = ParameterStatus::held;
  double data_share = 0.0;  ///< of the information: 1 without prior, 0 held
  std::string reason;       ///< why it is held
};

/// A direction that the readings do not see, and what was held for it.
struct UnseenDirection {
  std::string held;
  std::string description;                                  ///< in words
  std::vector<std::pair<std::string, double>> combination;  ///< moves every reading like these
};

struct NuisanceValue {
  std::string name;  ///< setup.A.x
  ParameterUnit unit = ParameterUnit::mm;
  double value = 0.0;
  double u = 0.0;
};

/// Lengths of residual vectors (of distances: their magnitudes), mm.
struct ResidualStatistics {
  Eigen::Index count = 0;
  double rms_mm = 0.0;
  double mean_mm = 0.0;
  double max_mm = 0.0;
  /// Rms that a perfect arm would show, every reading scattering as stated: root of the mean, over
  /// these rows, of the trace of their stated covariance (reference and encoders; poses: a third of
  /// it, for they are three points).
  double floor_mm = 0.0;
};

struct GroupResult {
  std::string name;
  ReferenceKind kind = ReferenceKind::reference_points;
  ResidualStatistics nominal;  ///< of the rows that were fitted, before: nominal arm, frames and
                               ///< points at their start
  ResidualStatistics fit;
  std::optional<ResidualStatistics> check;  ///< held-out rows, with what the fit found
  /// The same rows before: on the nominal arm, with frames and points at their start.
  std::optional<ResidualStatistics> check_nominal;
  /// The same after frames, points, spheres and planes were found anew on the held-out rows, the
  /// arm staying.
  std::optional<ResidualStatistics> check_registered;
};

/// A row that does not belong to the others.
struct FlaggedRow {
  std::string group;
  SourcePosition where;
  double residual_mm = 0.0;
  double normalised = 0.0;  ///< residual over its usual size
  bool is_check = false;
};

/// Numbers that one row compares: a distance, x y z, or those of three points.
using RowComponents = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 9, 1>;

/// Residual of one row: measured - predicted, the arm being what predicts. NaN where a kind has no
/// such thing.
struct RowResidual {
  int group = 0;
  int row = 0;
  bool is_check = false;       ///< held out: with what the fit found
  double residual_mm = 0.0;    ///< length, as in ResidualStatistics
  double nominal_residual_mm;  ///< the same on the nominal arm, frames and points at their start
  Eigen::Vector3d point_mm;    ///< the measured point by the calibrated arm, base frame
  /// From there to where the reference has it, base frame. Of a distance, radius or surface: along
  /// it. Poses: of the origin of the target.
  Eigen::Vector3d vector_mm;
  RowComponents components;  ///< whitened: standard normal where the stated uncertainties are right

  /// Root mean square of the components; of a single one itself, with its sign.
  [[nodiscard]] double normalised() const {
    return components.size() == 1
               ? components(0)
               : components.norm() / std::sqrt(static_cast<double>(components.size()));
  }
};

/// The costs of one least-squares solution: chi-squared (with priors; robust: the loss) at its
/// start and after every step.
struct SolutionTrace {
  std::string stage;  ///< "geometry": harmonics still at their nominal values; or "all"
  int unknowns = 0;
  std::vector<double> costs;
};

struct Calibration {
  CalibrationStatus status = CalibrationStatus::no_readings;
  std::string detail;
  Termination termination = Termination::not_finite;
  ArmModel nominal;
  ArmModel arm;
  std::vector<CalibratedParameter> parameters;  ///< all, in table order
  std::vector<NuisanceValue> nuisances;
  std::vector<UnseenDirection> unseen;
  /// Covariance of the free arm parameters, widened like their u, and their table indices.
  Eigen::MatrixXd covariance;
  std::vector<int> free;
  int rank = 0;      ///< unknowns that were estimated
  int unknowns = 0;  ///< that were asked for
  double condition_number = 1.0;
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  double sigma0 =
      1.0;  ///< sqrt(chi_squared / degrees_of_freedom): 1 where the stated uncertainties are right
  double chi_squared_probability = 1.0;
  int iterations = 0;
  std::vector<GroupResult> groups;
  std::vector<FlaggedRow> flagged;
  std::vector<RowResidual> residuals;  ///< by group, in file order
  /// In their order: what is determined and how rows are weighed is asked again after each.
  std::vector<SolutionTrace> convergence;
  /// Share of held-out rows that lie within their predicted 95 % region; nothing without such rows.
  std::optional<double> check_coverage;
  Eigen::Index check_count = 0;

  [[nodiscard]] bool ok() const { return status == CalibrationStatus::converged; }
};

/// Least-squares identification of an arm from any mixture of references. Everything that the
/// readings can determine is estimated; what they cannot see is held at its nominal value in the
/// order of `wanted_order`, and told. theory/identification.md.
[[nodiscard]] Calibration calibrate(const ArmModel& nominal,
                                    std::span<const ObservationGroup> groups,
                                    const CalibrationOptions& options);

/// What a session would determine, before anything is fitted: the same choice of unknowns at the
/// nominal arm, with the standard uncertainties that the stated ones of the readings promise.
/// Values are nominal.
[[nodiscard]] Calibration identifiability(const ArmModel& nominal,
                                          std::span<const ObservationGroup> groups,
                                          const CalibrationOptions& options);

/// Standard uncertainty of the tip at a posture (rows and columns x y z, mm^2), from the covariance
/// of the free parameters of `arm`.
[[nodiscard]] Eigen::Matrix3d tip_covariance(const ArmModel& arm, const std::vector<int>& free,
                                             const Eigen::MatrixXd& covariance,
                                             std::span<const double> encoder_rad);

}  // namespace armcal
