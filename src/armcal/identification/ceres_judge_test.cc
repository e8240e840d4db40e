// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0

// Ceres as an independent judge: the same readings, the same free parameters, a second forward
// kinematics with automatic derivatives, another solver, other starts of the frames. Only the arm's
// plain data and the readings are shared.
#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "armcal/arm/forward_kinematics.h"
#include "armcal/arm/inverse_kinematics.h"
#include "armcal/identification/calibration.h"
#include "armcal/numerics/distributions.h"
#include "armcal/testing/random_arms.h"
#include "armcal/testing/second_kinematics.h"
#include "armcal/testing/wang2016_arm.h"

namespace armcal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::SecondKinematics;

constexpr double kReadingNoise_mm = 0.01;

// --- simulated readings ------------------------------------------------------------------------

struct Simulation {
  ArmModel nominal;
  ArmModel truth;
  std::vector<ObservationGroup> groups;
};

// Every number off by about 5 mm or 2 deg.
ArmModel with_errors(ArmModel arm, RandomStream& random) {
  constexpr double kLength_mm = 5.0;
  constexpr double kAngle_rad = 2.0 * std::numbers::pi / 180.0;
  for (Joint& joint : arm.joints) joint.zero_rad += kAngle_rad * random.normal();
  for (Link& link : arm.links) {
    link.alpha_rad += kAngle_rad * random.normal();
    for (double* length : {&link.d_mm, &link.b_mm, &link.a_mm}) {
      *length += kLength_mm * random.normal();
    }
  }
  for (double* length : {&arm.tip.a_mm, &arm.tip.b_mm, &arm.tip.d_mm}) {
    *length += kLength_mm * random.normal();
  }
  return arm;
}

ObservationGroup group_of(std::string name, ReferenceKind kind, const MatrixXd& encoder_rad) {
  ObservationGroup group;
  group.name = std::move(name);
  group.kind = kind;
  const Index count = encoder_rad.cols();
  group.encoder_rad = encoder_rad;
  group.u_mm = VectorXd::Constant(count, kReadingNoise_mm);
  group.is_check.assign(static_cast<std::size_t>(count), false);
  for (int i = 0; i < static_cast<int>(count); ++i) group.lines.push_back(i + 2);
  return group;
}

std::span<const double> posture(const MatrixXd& encoder_rad, Index i) {
  return {encoder_rad.col(i).data(), static_cast<std::size_t>(encoder_rad.rows())};
}

ObservationGroup reference_points(const std::string& setup, int count, const ArmModel& truth,
                                  RandomStream& random) {
  const ForwardKinematics arm(truth);
  const RigidTransform frame = testing::random_transform(random, 500.0);
  ObservationGroup group = group_of("points " + setup, ReferenceKind::reference_points,
                                    testing::random_postures(truth.joint_count(), count, random));
  group.place.assign(static_cast<std::size_t>(count), setup);
  group.reference_mm.resize(3, count);
  for (Index i = 0; i < count; ++i) {
    group.reference_mm.col(i) = frame * arm.tip_in_base(posture(group.encoder_rad, i)) +
                                testing::random_normal_vector(random, kReadingNoise_mm);
  }
  return group;
}

// Postures whose tips lie in one seat but for the noise.
ObservationGroup fixed_point(const std::string& name, const Vector3d& seat_mm, int count,
                             const ArmModel& truth, RandomStream& random) {
  const ForwardKinematics arm(truth);
  const int n = truth.joint_count();
  MatrixXd postures(n, count);
  for (Index i = 0; i < count;) {
    const Vector3d tip = seat_mm + testing::random_normal_vector(random, kReadingNoise_mm);
    const std::vector<double> start = testing::random_posture(n, random);
    const PostureSearch search = find_posture(arm, tip, Eigen::Map<const VectorXd>(start.data(), n),
                                              {.tolerance_mm = 1e-10});
    postures.col(i) = search.encoder_rad;
    if (search.found) ++i;
  }
  ObservationGroup group = group_of("seat " + name, ReferenceKind::fixed_point, postures);
  group.place.assign(static_cast<std::size_t>(count), name);
  return group;
}

Simulation one_setup(std::uint64_t draw) {
  RandomStream random(draw);
  Simulation simulation{testing::nominal_romer(), {}, {}};
  simulation.truth = with_errors(simulation.nominal, random);
  for (const std::size_t joint : {1U, 2U, 3U}) {
    simulation.truth.joints[joint].harmonics.push_back(
        {1e-3 * random.normal(), 1e-3 * random.normal()});
  }
  simulation.groups.push_back(reference_points("A", 250, simulation.truth, random));
  return simulation;
}

Simulation seats_and_a_length(std::uint64_t draw) {
  RandomStream random(draw);
  Simulation simulation{testing::nominal_romer(), {}, {}};
  simulation.truth = with_errors(simulation.nominal, random);
  const ForwardKinematics arm(simulation.truth);
  std::vector<Vector3d> seats;
  for (const std::string name : {"P", "Q", "R", "S"}) {
    seats.push_back(arm.tip_in_base(testing::random_posture(6, random)));
    simulation.groups.push_back(fixed_point(name, seats.back(), 50, simulation.truth, random));
  }
  ObservationGroup length = group_of("bar", ReferenceKind::length, MatrixXd(0, 1));
  length.u_mm(0) = 0.005;
  length.value_mm = VectorXd::Constant(1, (seats[0] - seats[2]).norm() + 0.005 * random.normal());
  length.place = {"P"};
  length.place_to = {"R"};
  simulation.groups.push_back(length);
  return simulation;
}

Simulation three_setups_of_seven_joints(std::uint64_t draw) {
  RandomStream random(draw);
  Simulation simulation;
  simulation.nominal = testing::random_arm(
      7, random, {.arbitrary_twists = false, .beta = false, .harmonics = 0, .mount = true});
  simulation.truth = with_errors(simulation.nominal, random);
  for (const std::string setup : {"A", "B", "C"}) {
    simulation.groups.push_back(reference_points(setup, 70, simulation.truth, random));
  }
  return simulation;
}

// --- the judge ---------------------------------------------------------------------------------

struct PointInFrame {
  const SecondKinematics* arm;
  const double* encoder_rad;
  Vector3d reference_mm;
  double u_mm;

  template <class T>
  bool operator()(T const* const* x, T* residual) const {
    const std::array<T, 3> tip = arm->tip(x[0], encoder_rad);
    ceres::AngleAxisRotatePoint(x[1] + 3, tip.data(), residual);
    for (int c = 0; c < 3; ++c) residual[c] = (residual[c] + x[1][c] - reference_mm(c)) / u_mm;
    return true;
  }
};

struct PointInSeat {
  const SecondKinematics* arm;
  const double* encoder_rad;
  double u_mm;

  template <class T>
  bool operator()(T const* const* x, T* residual) const {
    const std::array<T, 3> tip = arm->tip(x[0], encoder_rad);
    for (std::size_t c = 0; c < 3; ++c) residual[c] = (tip[c] - x[1][c]) / u_mm;
    return true;
  }
};

struct LengthBetween {
  double value_mm;
  double u_mm;

  template <class T>
  bool operator()(T const* const* x, T* residual) const {
    using std::sqrt;
    T square(0.0);
    for (int c = 0; c < 3; ++c) square += (x[0][c] - x[1][c]) * (x[0][c] - x[1][c]);
    residual[0] = (sqrt(square) - value_mm) / u_mm;
    return true;
  }
};

// Distances between the tips at neighbouring postures: what an arm predicts, whatever its frame.
struct Distances {
  const SecondKinematics* arm;
  const MatrixXd* encoder_rad;

  template <class T>
  bool operator()(T const* const* x, T* distance) const {
    using std::sqrt;
    for (Index i = 0; i + 1 < encoder_rad->cols(); ++i) {
      const std::array<T, 3> p = arm->tip(x[0], encoder_rad->col(i).data());
      const std::array<T, 3> q = arm->tip(x[0], encoder_rad->col(i + 1).data());
      T square(0.0);
      for (std::size_t c = 0; c < 3; ++c) square += (p[c] - q[c]) * (p[c] - q[c]);
      distance[i] = sqrt(square);
    }
    return true;
  }
};

VectorXd free_values(const Calibration& calibration, double CalibratedParameter::*which) {
  VectorXd values(static_cast<Index>(calibration.free.size()));
  for (std::size_t i = 0; i < calibration.free.size(); ++i) {
    values(static_cast<Index>(i)) =
        calibration.parameters[static_cast<std::size_t>(calibration.free[i])].*which;
  }
  return values;
}

template <class Functor>
std::unique_ptr<ceres::CostFunction> automatic(Functor functor, const std::vector<Index>& sizes,
                                               Index residuals) {
  auto cost = std::make_unique<ceres::DynamicAutoDiffCostFunction<Functor, 8>>(
      new Functor(std::move(functor)));
  for (const Index size : sizes) cost->AddParameterBlock(static_cast<int>(size));
  cost->SetNumResiduals(static_cast<int>(residuals));
  return cost;
}

class Judge {
 public:
  Judge(const Simulation& simulation, const Calibration& calibration)
      : arm_(calibration.nominal, calibration.free),
        x_(free_values(calibration, &CalibratedParameter::nominal)) {
    for (const ObservationGroup& group : simulation.groups) add(group);
  }

  ceres::Solver::Summary solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.function_tolerance = 1e-16;
    options.gradient_tolerance = 1e-16;
    options.parameter_tolerance = 1e-14;
    options.max_num_iterations = 200;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    return summary;
  }

  [[nodiscard]] const VectorXd& arm() const { return x_; }
  /// Set-ups: x y z rx ry rz; points: x y z.
  [[nodiscard]] const std::map<std::string, VectorXd>& others() const { return others_; }

  MatrixXd covariance() {
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    ceres::Covariance covariance(options);
    EXPECT_TRUE(covariance.Compute(std::vector<const double*>{x_.data()}, &problem_));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix(x_.size(),
                                                                                  x_.size());
    EXPECT_TRUE(covariance.GetCovarianceBlock(x_.data(), x_.data(), matrix.data()));
    return matrix;
  }

 private:
  [[nodiscard]] Vector3d nominal_tip(const double* encoder_rad) const {
    const auto tip = arm_.tip(x_.data(), encoder_rad);
    return {tip[0], tip[1], tip[2]};
  }

  void add(const ObservationGroup& group) {
    if (group.kind == ReferenceKind::length) {
      std::vector<double*> ends{others_.at("point." + group.place[0]).data(),
                                others_.at("point." + group.place_to[0]).data()};
      add(automatic(LengthBetween{group.value_mm(0), group.u_mm(0)}, {3, 3}, 1), ends);
      return;
    }
    Eigen::Matrix3Xd tips(3, group.count());
    for (Index i = 0; i < group.count(); ++i) {
      tips.col(i) = nominal_tip(group.encoder_rad.col(i).data());
    }
    const bool seat = group.kind == ReferenceKind::fixed_point;
    VectorXd& other = others_[(seat ? "point." : "setup.") + group.place[0]];
    other = seat ? VectorXd(tips.rowwise().mean()) : frame_by_umeyama(tips, group.reference_mm);
    for (Index i = 0; i < group.count(); ++i) {
      const double* encoder = group.encoder_rad.col(i).data();
      const double u = group.u_mm(i);
      const std::vector<Index> sizes{x_.size(), other.size()};
      auto cost =
          seat ? automatic(PointInSeat{&arm_, encoder, u}, sizes, 3)
               : automatic(PointInFrame{&arm_, encoder, group.reference_mm.col(i), u}, sizes, 3);
      add(std::move(cost), {x_.data(), other.data()});
    }
  }

  void add(std::unique_ptr<ceres::CostFunction> cost, const std::vector<double*>& blocks) {
    problem_.AddResidualBlock(cost.release(), nullptr, blocks);
  }

  static VectorXd frame_by_umeyama(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xd& target) {
    const Eigen::Matrix4d frame = Eigen::umeyama(source, target, false);
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(frame.topLeftCorner<3, 3>()));
    VectorXd x(6);
    x << frame.topRightCorner<3, 1>(), turn.angle() * turn.axis();
    return x;
  }

  SecondKinematics arm_;
  VectorXd x_;
  std::map<std::string, VectorXd> others_;
  ceres::Problem problem_;
};

// --- what must hold ----------------------------------------------------------------------------

void expect_same_arm(const Calibration& calibration, const VectorXd& theirs) {
  for (std::size_t i = 0; i < calibration.free.size(); ++i) {
    const auto& ours = calibration.parameters[static_cast<std::size_t>(calibration.free[i])];
    EXPECT_NEAR(ours.value, theirs(static_cast<Index>(i)),
                ours.unit == ParameterUnit::mm ? 1e-6 : 1e-9)
        << ours.name;
  }
}

// Frames (shift, then turn) and points, in the order in which both name them.
void expect_same_others(const Calibration& calibration,
                        const std::map<std::string, VectorXd>& theirs) {
  Index compared = 0;
  for (const auto& [name, values] : theirs) {
    Index i = 0;
    for (const NuisanceValue& ours : calibration.nuisances) {
      if (!ours.name.starts_with(name + ".")) continue;
      ASSERT_LT(i, values.size());
      EXPECT_NEAR(ours.value, values(i++), ours.unit == ParameterUnit::mm ? 1e-6 : 1e-9)
          << ours.name;
    }
    EXPECT_EQ(i, values.size()) << name;
    compared += i;
  }
  EXPECT_EQ(compared, static_cast<Index>(calibration.nuisances.size()));
}

// Relative to the uncertainties of row and column: an entry alone may be zero.
void expect_same_covariance(const Calibration& calibration, const MatrixXd& theirs) {
  // Calibration widens what the readings scatter more than stated.
  const double widening = std::max(1.0, calibration.sigma0);
  const MatrixXd ours = calibration.covariance / (widening * widening);
  ASSERT_EQ(ours.rows(), theirs.rows());
  const VectorXd scales = theirs.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd difference = scales.asDiagonal() * (ours - theirs) * scales.asDiagonal();
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-6);
}

// What is held is a convention, so parameters of the truth are not those of the result: but there
// is a set with the same held ones that predicts what the truth does. It lies where the predicted
// distances lead from the result, and must be as far away as the covariance says.
void expect_truth_within_uncertainty(const Simulation& simulation, const Calibration& calibration,
                                     const MatrixXd& covariance) {
  RandomStream random(9);
  const MatrixXd postures = testing::random_postures(simulation.truth.joint_count(), 201, random);
  const VectorXd x = free_values(calibration, &CalibratedParameter::value);
  const SecondKinematics result(calibration.nominal, calibration.free);
  const auto predict = automatic(Distances{&result, &postures}, {x.size()}, 200);
  VectorXd predicted(200);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> J(200, x.size());
  const double* const block = x.data();
  double* jacobian = J.data();
  ASSERT_TRUE(predict->Evaluate(&block, predicted.data(), &jacobian));

  const SecondKinematics truth(simulation.truth, {});
  VectorXd real(200);
  const double* none = nullptr;
  ASSERT_TRUE((Distances{&truth, &postures}(&none, real.data())));

  const VectorXd error = predicted - real;
  const VectorXd off = J.completeOrthogonalDecomposition().solve(error);
  // Nothing is left over: the truth can be said with these free parameters. (Second order: errors
  // of 0.01 mm on a metre, squared.)
  EXPECT_LT((error - J * off).cwiseAbs().maxCoeff(), 1e-5);
  const double chi_squared = off.dot(covariance.ldlt().solve(off));
  const double probability = chi_squared_survival(chi_squared, static_cast<double>(x.size()));
  EXPECT_GT(probability, 1e-3) << chi_squared << " for " << x.size();
  EXPECT_LT(probability, 1.0 - 1e-3) << chi_squared << " for " << x.size();
}

void expect_the_judge_agrees(const Simulation& simulation, const CalibrationOptions& options,
                             std::size_t free) {
  const Calibration calibration = calibrate(simulation.nominal, simulation.groups, options);
  ASSERT_TRUE(calibration.ok()) << explain(calibration.status) << " " << calibration.detail;
  ASSERT_EQ(calibration.free.size(), free);
  // Nothing beside the arm is held.
  ASSERT_EQ(calibration.rank, static_cast<int>(free + calibration.nuisances.size()));
  EXPECT_GT(calibration.chi_squared_probability, 1e-3);

  Judge judge(simulation, calibration);
  const ceres::Solver::Summary summary = judge.solve();
  ASSERT_EQ(summary.termination_type, ceres::CONVERGENCE) << summary.message;
  EXPECT_NEAR(calibration.chi_squared / (2.0 * summary.final_cost), 1.0, 1e-11);
  expect_same_arm(calibration, judge.arm());
  expect_same_others(calibration, judge.others());
  const MatrixXd covariance = judge.covariance();
  expect_same_covariance(calibration, covariance);
  expect_truth_within_uncertainty(simulation, calibration, covariance);
}

TEST(CeresJudge, agrees_on_an_arm_with_harmonics_on_reference_points_in_one_set_up) {
  CalibrationOptions options;
  options.harmonics = 1;
  options.hold = {"cos1_1", "sin1_1", "cos1_5", "sin1_5", "cos1_6", "sin1_6"};
  for (const std::uint64_t draw : {101U, 1101U}) {
    SCOPED_TRACE(draw);
    expect_the_judge_agrees(one_setup(draw), options, 27);
  }
}

TEST(CeresJudge, agrees_on_fixed_points_and_one_length) {
  // The second: tips that miss their seats by the noise let a turn of the base count as seen.
  for (const std::uint64_t draw : {102U, 5102U}) {
    SCOPED_TRACE(draw);
    expect_the_judge_agrees(seats_and_a_length(draw), {}, 21);
  }
}

TEST(CeresJudge, agrees_on_a_seven_joint_arm_in_three_set_ups) {
  // The last two: the identification took rounding for a failed step, and ended without a result.
  for (const std::uint64_t draw : {103U, 14103U, 38103U}) {
    SCOPED_TRACE(draw);
    expect_the_judge_agrees(three_setups_of_seven_joints(draw), {}, 25);
  }
}

}  // namespace
}  // namespace armcal
